// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_H

// The scene, as all rooms see it. One pass over the coordinates finds it.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the ends of intervals.
inline std::vector<std::pair<double, double>> ends_of(const std::vector<Interval>& intervals)
{
  std::vector<std::pair<double, double>> ends(intervals.size());
  for(std::size_t i = 0; i < ends.size(); ++i)
    ends[i] = {intervals[i].low, intervals[i].high};
  return ends;
}

struct Scene
{
  std::size_t size = 0;      // the number of points
  std::vector<Interval> box; // of the coordinates along each axis, rounded outwards

  // The bounds of a coordinate are at most this far apart. If it is zero, the bounds are equal, so
  // all coordinates are doubles, whatever their type.
  double error = 0;

  // The exponent of the coarsest grid 2^e Z that holds all coordinates along the axes along which
  // the points differ. None if the error is not zero, or if the scan did not look for the grid.
  std::optional<int> grid_exponent;

  int dimension() const { return static_cast<int>(box.size()); }

  // Whether the points differ along an axis. If not, all coordinates along it are the same double.
  bool is_extended_along(int axis) const
  {
    const Interval& interval = box[static_cast<std::size_t>(axis)];
    return interval.low < interval.high;
  }

  // The largest absolute value of a bound of a coordinate.
  double largest_coordinate() const
  {
    double largest = 0;
    for(const Interval& interval : box)
      largest = (std::max)({largest, -interval.low, interval.high});
    return largest;
  }

  // Returns the exponent of the grid, given the grids along all axes.
  int exponent_of(const std::vector<Double_grid>& grids) const
  {
    Double_grid grid;
    for(int axis = 0; axis < dimension(); ++axis)
      if(is_extended_along(axis))
        grid.add(grids[static_cast<std::size_t>(axis)]);
    return grid.exponent();
  }

  int extended_axis_count() const
  {
    int count = 0;
    for(int axis = 0; axis < dimension(); ++axis)
      count += is_extended_along(axis);
    return count;
  }
};

// What one pass over kernel objects finds: where they are, how large they are, and the grid of
// their coordinates.
struct Object_scene
{
  std::size_t size = 0;
  std::vector<Interval> box;   // of all objects; empty if there are none
  std::vector<double> reaches; // along an axis, of points of two objects whose boxes meet
  std::optional<int> grid_exponent; // if all numbers are doubles
  bool has_distances = false;  // whether distances of objects are compared, and not only signs
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCENE_H
