// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The boxes of objects as CGAL's box intersection takes them, of ends of any type.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_BOXES_OF_OBJECTS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_BOXES_OF_OBJECTS_H

#include "on_objects.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Dimension.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace thick_benchmark {

template <class Object>
constexpr int object_dimension = CGAL::Ambient_dimension<Object>::value;
template <>
inline constexpr int object_dimension<Ball_3> = 3;

template <class NT, int Dimension>
using Box_of_object = CGAL::Box_intersection_d::Box_with_info_d<NT, Dimension, std::uint32_t>;

template <class NT, class Object, class Round>
auto box_of(const Object& object, std::uint32_t position, const Round&)
{
  const auto bbox = object.bbox();
  constexpr int dimension = object_dimension<Object>;
  NT low[dimension], high[dimension];
  for(int axis = 0; axis < dimension; ++axis) {
    low[axis] = static_cast<NT>((bbox.min)(axis));
    high[axis] = static_cast<NT>((bbox.max)(axis));
  }
  return Box_of_object<NT, dimension>(low, high, position);
}

// round(x, infinity) rounds the ends; see box_intersection.h.
template <class NT, class Round>
auto box_of(const Ball_3& ball, std::uint32_t position, const Round& round)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  NT low[3], high[3];
  for(int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<NT>(round(ball.first[axis] - ball.second, -infinity));
    high[axis] = static_cast<NT>(round(ball.first[axis] + ball.second, infinity));
  }
  return Box_of_object<NT, 3>(low, high, position);
}

template <class NT, class Object, class Round>
auto boxes_of(const std::vector<Object>& objects, const Round& round)
{
  std::vector<decltype(box_of<NT>(objects[0], 0, round))> boxes;
  boxes.reserve(objects.size());
  for(std::size_t i = 0; i < objects.size(); ++i)
    boxes.push_back(box_of<NT>(objects[i], static_cast<std::uint32_t>(i), round));
  return boxes;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_BOXES_OF_OBJECTS_H
