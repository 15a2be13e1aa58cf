// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H

// The bounding box of an object, and the check that its vertices are finite.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Circle_2.h>
#include <CGAL/Sphere_3.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A Bbox has no bbox(). It is its own box.
inline const Bbox_2& bounding_box(const Bbox_2& box) { return box; }
inline const Bbox_3& bounding_box(const Bbox_3& box) { return box; }

// Whether a box is finite and not empty. An empty Bbox begins behind its end.
template <class Box>
bool is_finite_box(const Box& box)
{
  for(int i = 0; i < box.dimension(); ++i)
    if(!std::isfinite((box.min)(i)) || !std::isfinite((box.max)(i))
       || (box.min)(i) > (box.max)(i))
      return false;
  return true;
}

// Returns the box of the type Bbox_2 or Bbox_3 with these intervals along the axes.
template <class Box, class Interval_of_axis>
Box box_of_intervals(const Interval_of_axis& interval)
{
  const auto x = interval(0), y = interval(1);
  if constexpr(std::is_same_v<Box, Bbox_2>)
    return Box(x.first, y.first, x.second, y.second);
  else {
    const auto z = interval(2);
    return Box(x.first, y.first, z.first, x.second, y.second, z.second);
  }
}

template <class Box, class Point>
Box bounding_box_of_point(const Point& p)
{
  return box_of_intervals<Box>([&](int i) { return coordinate_bounds(p, i); });
}

// The same of a vertex of an object. Numbers beyond the doubles count as the
// largest double: the order of ends does not change, so boxes that meet still meet.
template <class Box, class Object>
Box bounding_box_of_vertex(const Object& object, int v)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  return box_of_intervals<Box>([&](int i) {
    const std::pair<double, double> x = vertex_bounds(object, v, i);
    return std::pair((std::clamp)(x.first, -largest, largest),
                     (std::clamp)(x.second, -largest, largest));
  });
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

template <class Object>
struct Is_hypersphere : std::false_type {};
template <class K>
struct Is_hypersphere<Circle_2<K>> : std::true_type {};
template <class K>
struct Is_hypersphere<Sphere_3<K>> : std::true_type {};

// Returns whether the bounding box of an object is the object.
template <class Object>
constexpr bool is_box_of_doubles()
{
  if constexpr(Vertex_count<Object>::value == 1 || is_iso_box_v<Object>)
    return has_double_vertices_v<Object>;
  else
    return std::is_same_v<Object, Bbox_2> || std::is_same_v<Object, Bbox_3>;
}

// Throws if a coordinate of a vertex is NaN or infinite. The bounding box does not show this,
// because the minimum of NaN and 1 may be 1.
template <class Object>
void check_vertices(const Object& object, std::size_t position)
{
  if constexpr(Vertex_count<Object>::value == 0) {
    if(!is_finite_box(bounding_box(object)))
      throw std::invalid_argument("The bounding box of object " + std::to_string(position)
                                  + " is empty or not finite.");
  }
  else
    for(int v = 0; v < Vertex_count<Object>::value; v += Vertex_step<Object>::value)
      for(int i = 0; i < vertex_dimension_v<Object>; ++i)
        if(!are_bounds_of_finite(vertex_bounds(object, v, i)))
          throw_not_finite("vertex of object", position, i);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
