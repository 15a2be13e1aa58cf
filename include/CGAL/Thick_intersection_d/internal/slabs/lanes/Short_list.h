// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LIST_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LIST_H

// A list of distinct positions, for lanes to sort.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <array>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The room for positions fills two cache lines. Most points of scenes with 20 neighbors per point
// have no more.
struct alignas(64) Short_list
{
  static constexpr Place capacity = 32;

  std::array<Place, capacity> positions;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LIST_H
