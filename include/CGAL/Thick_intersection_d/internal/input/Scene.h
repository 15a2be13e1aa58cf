// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_H

// What one pass over the coordinates of some points finds: the scene, as all wings see it.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Scene
{
  std::size_t size = 0;      // the number of points
  std::vector<Interval> box; // of the coordinates along each axis, rounded outwards

  // The two doubles around a coordinate are at most this far apart. It is zero if and only if all
  // coordinates are doubles, whatever their type.
  double error = 0;

  // The exponent of the coarsest grid 2^e Z that holds all coordinates along the axes along which
  // the points differ. There is none unless all coordinates are doubles.
  std::optional<int> grid_exponent;

  int dimension() const { return static_cast<int>(box.size()); }

  // Whether the points differ along an axis; if not, all their coordinates are the same double.
  bool is_extended_along(int axis) const
  {
    const Interval& interval = box[static_cast<std::size_t>(axis)];
    return interval.low < interval.high;
  }

  int extended_axis_count() const
  {
    int count = 0;
    for(int axis = 0; axis < dimension(); ++axis)
      count += is_extended_along(axis);
    return count;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_H
