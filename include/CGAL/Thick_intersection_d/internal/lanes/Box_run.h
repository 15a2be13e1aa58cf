// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_BOX_RUN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_BOX_RUN_H

// Boxes as columns, for lanes to sweep. Each box knows the places of its candidates: the boxes that
// it may meet along the sweep axis.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The first axis of the columns is the sweep axis. Behind the last box there are `lanes` boxes of
// NaN, which meet no box.
template <int Axes>
struct Box_run
{
  std::array<const double*, Axes> low;
  std::array<const double*, Axes> high;
  const Place* positions;
  const Place* sides;
  const Place* begins; // of the candidates of each box, in this run or in another one
  const Place* ends;
  Place first; // a sweep starts from the boxes at the places [first, last)
  Place last;
  bool has_copies; // whether a box is a copy along any axis

  // The number of candidates of the boxes that a sweep starts from.
  std::uint64_t candidate_count() const
  {
    std::uint64_t count = 0;
    for(Place i = first; i < last; ++i)
      count += ends[i] - begins[i];
    return count;
  }

  // Returns one of `count` blocks of the run. A sweep starts from the boxes of the block.
  Box_run block(Place index, Place count) const
  {
    const std::uint64_t size = last - first;
    Box_run block = *this;
    block.first = first + static_cast<Place>(size * index / count);
    block.last = first + static_cast<Place>(size * (index + 1) / count);
    return block;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_BOX_RUN_H
