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
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
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

// Returns a functor: of an axis, gives the interval of a box along it.
template <class Box>
auto intervals_of(const Box& box)
{
  return [box](int axis) { return Interval{(box.min)(axis), (box.max)(axis)}; };
}

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

template <int Dimension>
using Bbox_of_dimension = std::conditional_t<Dimension == 2, Bbox_2, Bbox_3>;

template <class Box, class Point>
Box bounding_box_of_point(const Point& p)
{
  return box_of_intervals<Box>([&](int i) { return coordinate_bounds(p, i); });
}

// Numbers beyond the doubles count as the largest double: the order of ends does not change, so
// boxes that meet still meet.
inline std::pair<double, double> finite_interval(const std::pair<double, double>& x)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  return {(std::clamp)(x.first, -largest, largest), (std::clamp)(x.second, -largest, largest)};
}

// The same of a vertex of an object.
template <class Box, class Object>
Box bounding_box_of_vertex(const Object& object, int v)
{
  return box_of_intervals<Box>([&](int i) { return finite_interval(vertex_bounds(object, v, i)); });
}

// That of an object in a box, thickened by a radius.
template <class Box, class NT>
Box thickened_box(const Box& box, const NT& radius)
{
  return box_of_intervals<Box>([&](int i) {
    return finite_interval(thickened_interval({(box.min)(i), (box.max)(i)}, radius));
  });
}

template <class Object>
auto bounding_box(const Object& object)
{
  if constexpr(is_mixed_v<Object>)
    return with_kind(object, [](const auto& kind) { return internal::bounding_box(kind); });
  else if constexpr(Is_thickened<Object>::value)
    return thickened_box(internal::bounding_box(hull_points(object)), object.second);
  else if constexpr(Vertex_count<Object>::value == 0)
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

// The type of the bounding box of an object: Bbox_2 or Bbox_3.
template <class Object>
using Bounding_box_t = std::decay_t<decltype(internal::bounding_box(
  std::declval<const Object&>()))>;

// Whether objects of a kind, which have a box, are in the plane.
template <class Kind>
struct Is_planar : std::is_same<Bounding_box_t<Kind>, Bbox_2>
{};

// Checks that the kinds of an object are of one dimension.
template <class Object>
constexpr bool check_one_dimension()
{
  constexpr bool has_one
    = Kinds<Object>::template are_all<Is_planar> || !Kinds<Object>::template is_any<Is_planar>;
  static_assert(has_one, "The objects must be all in the plane, or all in space.");
  return has_one;
}

template <class Object>
struct Is_hypersphere : std::false_type {};
template <class K>
struct Is_hypersphere<Circle_2<K>> : std::true_type {};
template <class K>
struct Is_hypersphere<Sphere_3<K>> : std::true_type {};

// Returns whether the bounding box of an object of one kind is the object.
template <class Object>
constexpr bool is_box_of_doubles()
{
  if constexpr(Vertex_count<Object>::value == 1 || is_iso_box_v<Object>)
    return has_double_vertices_v<Object>;
  else
    return false;
}
template <class Object>
struct Is_box_of_doubles : std::bool_constant<is_box_of_doubles<Object>()> {};

// Throws if a coordinate of a vertex is NaN or infinite. The bounding box does not show this,
// because the minimum of NaN and 1 may be 1.
template <class Object>
void check_vertices(const Object& object, std::size_t position)
{
  for(int v = 0; v < Vertex_count<Object>::value; v += Vertex_step<Object>::value)
    for(int i = 0; i < vertex_dimension_v<Object>; ++i)
      if(!are_bounds_of_finite(vertex_bounds(object, v, i)))
        throw_not_finite("vertex of object", position, i);
}

// Throws if an object has no finite place: if it has NaN or infinite numbers, or is empty.
template <class Object>
void check_object(const Object& object, std::size_t position)
{
  constexpr bool is_bbox = std::is_same_v<Object, Bbox_2> || std::is_same_v<Object, Bbox_3>;
  if constexpr(is_mixed_v<Object>)
    with_kind(object, [&](const auto& kind) { internal::check_object(kind, position); });
  else if constexpr(Is_thickened<Object>::value) {
    internal::check_object(hull_points(object), position);
    check_radius(object.second, position);
  }
  else if constexpr(Vertex_count<Object>::value != 0 && !is_bbox)
    check_vertices(object, position);
  else if(!is_finite_box(internal::bounding_box(object)))
    throw std::invalid_argument("The bounding box of object " + std::to_string(position)
                                + " is empty or not finite.");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
