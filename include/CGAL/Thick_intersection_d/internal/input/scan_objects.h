// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_OBJECTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_OBJECTS_H

// Finds the scene of kernel objects in one pass over them.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Refines the grid until it holds the numbers of an object: coordinates, and perhaps a radius.
// Returns false if one of them is no double.
template <class Object>
bool refine_grid(const Object& object, Double_grid& grid)
{
  if constexpr(is_mixed_v<Object>)
    return with_kind(object, [&](const auto& kind) { return refine_grid(kind, grid); });
  else if constexpr(Is_thickened<Object>::value) {
    const std::pair<double, double> radius = bounds(object.second);
    grid.add(radius.first);
    return radius.first == radius.second && refine_grid(hull_points(object), grid);
  }
  else
    return read_vertices(object, [&](std::size_t, int, double x) { grid.add(x); });
}

// Scans the boxes of objects: intervals(i)(axis) is what object i covers along an axis. Two objects
// whose boxes meet lie in a box of twice the largest extents. refine(i, grid) refines the grid
// until it holds the numbers of the object, and returns false if one of them is no double.
template <class Intervals, class Refine>
Object_scene scan_boxes(std::size_t size, int axis_count, const Intervals& intervals,
                        const Refine& refine)
{
  Object_scene scene;
  scene.size = size;
  scene.reaches.resize(size == 0 ? 0 : static_cast<std::size_t>(axis_count));
  scene.box.resize(scene.reaches.size());
  Double_grid grid;
  bool are_doubles = true;
  for(std::size_t i = 0; i < size; ++i) {
    const auto interval_along = intervals(i);
    for(std::size_t axis = 0; axis < scene.box.size(); ++axis) {
      const Interval interval = interval_along(static_cast<int>(axis));
      const double extent
        = std::nextafter(interval.length(), std::numeric_limits<double>::infinity());
      scene.reaches[axis] = (std::max)(scene.reaches[axis], 2 * extent);
      scene.box[axis].add(interval);
    }
    are_doubles = are_doubles && refine(i, grid);
  }
  if(are_doubles)
    scene.grid_exponent = grid.exponent();
  return scene;
}

// The objects are those that traits have checked.
template <class Elements>
Object_scene scan_objects(const Elements& objects)
{
  using Box = Bounding_box_t<typename Elements::value_type>;
  const auto intervals = [&](std::size_t i) {
    return intervals_of(internal::bounding_box(objects[i]));
  };
  const auto refine = [&](std::size_t i, Double_grid& grid) {
    return refine_grid(objects[i], grid);
  };
  return scan_boxes(objects.size(), Box().dimension(), intervals, refine);
}

// Adds a bound on the distance of objects, which is between two doubles. Two objects whose boxes
// are within the reach lie in a box that is longer by it, along the axes of space.
inline void add_bound(Object_scene& scene, const std::pair<double, double>& bound, double reach,
                      int space_axes = 3)
{
  scene.has_distances = true;
  for(std::size_t axis = 0; axis < scene.reaches.size() && int(axis) < space_axes; ++axis)
    scene.reaches[axis] += reach;
  if(bound.first != bound.second)
    scene.grid_exponent.reset();
  if(scene.grid_exponent) {
    Double_grid grid(*scene.grid_exponent);
    grid.add(bound.first);
    scene.grid_exponent = grid.exponent();
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_OBJECTS_H
