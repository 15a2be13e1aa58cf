// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_POINT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_POINT_H

// Points as the slab route sees them: doubles, and the position in the user's range.

#include <array>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A position of a point, or an index into an array of points.
using Place = std::uint32_t;

template <int Dimension>
struct Slab_point
{
  std::array<double, Dimension> x;
  Place position;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_POINT_H
