// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H

// The bounding box of an object.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A Bbox has no bbox(). It is its own box.
inline const Bbox_2& bounding_box(const Bbox_2& box) { return box; }
inline const Bbox_3& bounding_box(const Bbox_3& box) { return box; }

template <class Box>
bool is_finite_box(const Box& box)
{
  for(int i = 0; i < box.dimension(); ++i)
    if(!std::isfinite((box.min)(i)) || !std::isfinite((box.max)(i)))
      return false;
  return true;
}

template <class Box, class Point>
Box bounding_box_of_point(const Point& p)
{
  const auto x = coordinate_bounds(p, 0), y = coordinate_bounds(p, 1);
  if constexpr(std::is_same_v<Box, Bbox_2>)
    return Box(x.first, y.first, x.second, y.second);
  else {
    const auto z = coordinate_bounds(p, 2);
    return Box(x.first, y.first, z.first, x.second, y.second, z.second);
  }
}

// Extends a box of the type Bbox_2 or Bbox_3 by a vertex. Numbers beyond the doubles count as the
// largest double: the order of ends does not change, so boxes that meet still meet.
template <class Box, class Object>
Box bounding_box_of_vertex(const Object& object, int v)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  const auto interval = [&](int i) {
    const std::pair<double, double> x = vertex_bounds(object, v, i);
    return std::pair((std::clamp)(x.first, -largest, largest),
                     (std::clamp)(x.second, -largest, largest));
  };
  const auto x = interval(0), y = interval(1);
  if constexpr(std::is_same_v<Box, Bbox_2>)
    return Box(x.first, y.first, x.second, y.second);
  else {
    const auto z = interval(2);
    return Box(x.first, y.first, z.first, x.second, y.second, z.second);
  }
}

template <class Object>
auto bounding_box(const Object& object)
{
  if constexpr(Vertex_count<Object>::value == 0)
    return object.bbox();
  else if constexpr(has_double_vertices_v<Object>)
    return object.bbox();
  else {
    using Box = decltype(object.bbox());
    Box box;
    for(int v = 0; v < Vertex_count<Object>::value; v += Vertex_step<Object>::value)
      box = box + bounding_box_of_vertex<Box>(object, v);
    return box;
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
