// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_PLAIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_PLAIN_H

// Short lists of distinct positions, and their order by plain loops.

#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>
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
static_assert(Short_list::capacity == max_run_size);

struct Short_lists_plain
{
  static bool is_supported() { return true; }

  // Writes the first `size` of some positions to `sorted` in ascending order. There is room for a
  // whole list in either place.
  static void sort(const Place* positions, Place size, Place* sorted)
  {
    sort_run_by_ranks(positions, size, sorted);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_SHORT_LISTS_PLAIN_H
