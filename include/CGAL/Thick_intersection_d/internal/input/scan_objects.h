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
    return radius.first == radius.second && refine_grid(object.first, grid);
  }
  else
    return read_vertices(object, [&](std::size_t, int, double x) { grid.add(x); });
}

// Two objects whose boxes meet lie in a box of twice the largest extents.
inline void extend_scene(Object_scene& scene, std::size_t axis, const Interval& interval)
{
  const double extent
    = std::nextafter(interval.high - interval.low, std::numeric_limits<double>::infinity());
  scene.reaches[axis] = (std::max)(scene.reaches[axis], 2 * extent);
  Interval& range = scene.box[axis];
  range = {(std::min)(range.low, interval.low), (std::max)(range.high, interval.high)};
}

// The objects are those that traits have checked.
template <class Elements>
Object_scene scan_objects(const Elements& objects)
{
  Object_scene scene;
  scene.size = objects.size();
  Double_grid grid;
  bool are_doubles = true;
  for(std::size_t i = 0; i < objects.size(); ++i) {
    const auto& object = objects[i];
    const auto& box = internal::bounding_box(object);
    const auto axes = static_cast<std::size_t>(box.dimension());
    if(i == 0) {
      scene.reaches.resize(axes);
      for(std::size_t axis = 0; axis < axes; ++axis)
        scene.box.push_back({(box.min)(int(axis)), (box.max)(int(axis))});
    }
    for(std::size_t axis = 0; axis < axes; ++axis)
      extend_scene(scene, axis, {(box.min)(int(axis)), (box.max)(int(axis))});
    are_doubles = are_doubles && refine_grid(object, grid);
  }
  if(are_doubles)
    scene.grid_exponent = grid.exponent();
  return scene;
}

// The same of objects and a bound on their distance, which is between two doubles. Two objects
// whose boxes are within the reach lie in a box that is longer by it.
template <class Elements>
Object_scene scan_near_objects(const Elements& objects, const std::pair<double, double>& bound,
                               double reach)
{
  Object_scene scene = scan_objects(objects);
  scene.has_distances = true;
  for(double& x : scene.reaches)
    x += reach;
  if(bound.first != bound.second)
    scene.grid_exponent.reset();
  if(scene.grid_exponent) {
    Double_grid grid(*scene.grid_exponent);
    grid.add(bound.first);
    scene.grid_exponent = grid.exponent();
  }
  return scene;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_OBJECTS_H
