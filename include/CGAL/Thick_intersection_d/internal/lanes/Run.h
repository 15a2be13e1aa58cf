// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_H

// Points in the order of axis 0, and boxes, as columns for lanes to sweep.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How many pairs are computed at once.
inline constexpr Place lanes = 8;

// Behind the last point there are `lanes` points that end all loops: along axis 0 they are beyond
// reach of all points and of each other. end_of_run() gives their coordinates.
template <int Dimension, class Number>
struct Run
{
  using Coordinate = Number;

  std::array<const Number*, Dimension> x;
  const Place* positions;
  Place size;

  // Returns one of `count` blocks of the run. A sweep starts from the points of the block, and
  // meets the points behind the block as well.
  Run block(Place index, Place count) const
  {
    const std::uint64_t groups = (size + lanes - 1) / lanes;
    const Place begin = static_cast<Place>(groups * index / count * lanes);
    const Place end = static_cast<Place>(groups * (index + 1) / count * lanes);
    Run block = *this;
    for(const Number*& column : block.x)
      column += begin;
    block.positions += begin;
    block.size = (std::min)(end, size) - begin;
    return block;
  }
};

// Returns the coordinate along axis 0 of the last points of a run. A point is near none if a
// coordinate is NaN.
template <class Number>
Number end_of_run(Place lane);
template <>
inline double end_of_run(Place)
{
  return std::numeric_limits<double>::quiet_NaN();
}

// Coordinates that are 32-bit integers are from zero to this number, and their reach is at most the
// other one. So no difference of coordinates overflows, those at the ends of runs included. Squared
// distances from the square of this reach on must be certainly beyond the bound, as those of the
// ends are.
inline constexpr std::int32_t max_narrow_coordinate = 1 << 30;
inline constexpr std::int32_t max_narrow_reach = 1 << 25;

template <>
inline std::int32_t end_of_run(Place lane)
{
  return max_narrow_coordinate + static_cast<std::int32_t>(lane + 1) * (max_narrow_reach + 1);
}

// Boxes as columns, for lanes to sweep. Each box knows the places of its candidates: the boxes that
// it may meet along the sweep axis.
//
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

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_RUN_H
