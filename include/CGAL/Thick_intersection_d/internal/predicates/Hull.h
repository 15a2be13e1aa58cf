// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_H

// An object of any kind, as the questions about distances see it: all that is within a radius of
// the convex hull of a few points. The radius is zero, but for balls, which have one point.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The points of the hull of an object of one kind: the object itself, or the center of a ball.
template <class Object>
decltype(auto) hull_points(const Object& object)
{
  if constexpr(Is_ball<Object>::value)
    return as_kind(object.first);
  else
    return (object);
}

template <class Object>
using Hull_points_t = std::decay_t<decltype(hull_points(std::declval<const Object&>()))>;

// How many points the hull of an object of one kind has. Those of an iso-box are numbered by bits.
template <class Object>
constexpr std::size_t hull_size_v
  = static_cast<std::size_t>(Vertex_count<Hull_points_t<Object>>::value);

template <class Object>
constexpr int hull_dimension_v = vertex_dimension_v<Hull_points_t<Object>>;

template <int Dimension, std::size_t Size>
struct Hull
{
  std::array<std::array<double, Dimension>, Size> vertices;

  // Each coordinate is at most that of the object, and off by at most the error.
  double error = 0;
  Interval radius = {0, 0};
};

template <class Object>
using Hull_of = Hull<hull_dimension_v<Object>, hull_size_v<Object>>;

// Returns a vertex of the hull of an object of doubles, or of a Hull.
template <class Object>
auto hull_vertex(const Object& object, std::size_t k)
{
  using Points = Hull_points_t<Object>;
  std::array<double, static_cast<std::size_t>(hull_dimension_v<Object>)> x;
  for(int axis = 0; axis < hull_dimension_v<Object>; ++axis) {
    const int v = place_of_vertex<Points, hull_size_v<Object>>(k, axis);
    x[axis] = static_cast<double>(coordinate(vertex_of(hull_points(object), v), axis));
  }
  return x;
}
template <int Dimension, std::size_t Size>
auto hull_vertex(const Hull<Dimension, Size>& hull, std::size_t k)
{
  return hull.vertices[k];
}

template <class Object>
Interval hull_radius(const Object& object)
{
  if constexpr(Is_ball<Object>::value) {
    const std::pair<double, double> radius = bounds(object.second);
    return {radius.first, radius.second};
  }
  else
    return {0, 0};
}

template <class Object>
Hull_of<Object> hull_of(const Object& object)
{
  constexpr std::size_t size = hull_size_v<Object>;
  using Points = Hull_points_t<Object>;
  Hull_of<Object> hull;
  hull.radius = hull_radius(object);
  const Points& points = hull_points(object);
  for(std::size_t k = 0; k < size; ++k)
    if constexpr(has_double_vertices_v<Points>)
      hull.vertices[k] = hull_vertex(object, k);
    else
      for(int axis = 0; axis < vertex_dimension_v<Points>; ++axis) {
        const auto x = vertex_bounds(points, place_of_vertex<Points, size>(k, axis), axis);
        hull.vertices[k][axis] = x.first;
        hull.error = (std::max)(hull.error, x.second - x.first);
      }
  return hull;
}

// The number type of the coordinates of an object.
template <class Object>
using Hull_number_t = Vertex_number_t<Hull_points_t<Object>>;

// That of its radius. An object that is no ball has the radius zero.
template <class Object, bool = Is_ball<Object>::value>
struct Radius_number
{
  using type = Hull_number_t<Object>;
};
template <class Object>
struct Radius_number<Object, true>
{
  using type = typename Object::second_type;
};

// Returns a coordinate or radius in an exact type, which holds it.
template <class Exact, class NT>
Exact exact_value(const NT& x)
{
  if constexpr(std::is_same_v<Exact, Exact_number_t<NT>>)
    return Exact(to_exact_number(x));
  else
    return Exact(to_exact_rational(x));
}

// Returns vertex k of the hull in exact numbers, which hold its coordinates.
template <class Exact, class Object>
std::array<Exact, hull_dimension_v<Object>> exact_hull_vertex(const Object& object, std::size_t k)
{
  using Points = Hull_points_t<Object>;
  const Points& points = hull_points(object);
  std::array<Exact, hull_dimension_v<Object>> x;
  for(int axis = 0; axis < hull_dimension_v<Object>; ++axis)
    x[axis] = exact_value<Exact>(
      coordinate(vertex_of(points, place_of_vertex<Points, hull_size_v<Object>>(k, axis)), axis));
  return x;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_H
