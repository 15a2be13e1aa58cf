// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_H

// An object of any kind, as the questions about distances see it: all that is within a radius of
// the convex hull of a few points. The radius is zero unless the object is thickened. A ball is
// one point, thickened.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How many points the hull of an object of one kind has. Those of an iso-box are numbered by bits.
template <class Object>
constexpr std::size_t hull_size_v
  = static_cast<std::size_t>(Vertex_count<Hull_points_t<Object>>::value);

template <class Object>
constexpr int hull_dimension_v = vertex_dimension_v<Hull_points_t<Object>>;

template <int Dimension>
struct Hull
{
  std::array<std::array<double, Dimension>, std::size_t(1) << Dimension> vertices;
  std::size_t size; // of them, those that the object has

  // Each coordinate is at most that of the object, and off by at most the error.
  double error = 0;
  Interval radius = {0, 0};

  // Whether the doubles are the object.
  bool is_exact() const { return error == 0 && radius.length() == 0; }
};

template <class Object>
using Hull_of = Hull<hull_dimension_v<Object>>;

template <class Object>
Interval hull_radius(const Object& object)
{
  if constexpr(Is_thickened<Object>::value) {
    const std::pair<double, double> radius = bounds(object.second);
    return {radius.first, radius.second};
  }
  else
    return {0, 0};
}

// Calls task(k) for the places 0, 1 and so on, each a constant: so arrays stay in registers.
template <class Task, std::size_t... K>
BOOST_FORCEINLINE void for_places(const Task& task, std::index_sequence<K...>)
{
  (task(std::integral_constant<std::size_t, K>()), ...);
}
template <std::size_t Size, class Task>
BOOST_FORCEINLINE void for_places(const Task& task)
{
  for_places(task, std::make_index_sequence<Size>());
}

template <class Object>
BOOST_FORCEINLINE Hull_of<Object> hull_of(const Object& object)
{
  using Points = Hull_points_t<Object>;
  Hull_of<Object> hull;
  hull.size = hull_size_v<Object>;
  hull.radius = hull_radius(object);
  const Points& points = hull_points(object);
  for_places<hull_size_v<Object>>([&](auto k) {
    for_places<hull_dimension_v<Object>>([&](auto axis) {
      const int v = place_of_vertex<Points, hull_size_v<Object>>(k, axis);
      if constexpr(has_double_vertices_v<Points>)
        hull.vertices[k][axis] = static_cast<double>(coordinate(vertex_of(points, v), axis));
      else {
        const auto x = vertex_bounds(points, v, axis);
        hull.vertices[k][axis] = x.first;
        hull.error = (std::max)(hull.error, x.second - x.first);
      }
    });
  });
  return hull;
}

// The number type of the coordinates of an object.
template <class Object>
using Hull_number_t = Vertex_number_t<Hull_points_t<Object>>;

// That of its radius, which is zero if the object is not thickened.
template <class Object, bool = Is_thickened<Object>::value>
struct Radius_number
{
  using type = Hull_number_t<Object>;
};
template <class Object>
struct Radius_number<Object, true>
{
  using type = typename Object::second_type;
};

// Returns vertex k of the hull in exact numbers, which hold its coordinates.
template <class Exact, class Object>
std::array<Exact, hull_dimension_v<Object>> exact_hull_vertex(const Object& object, std::size_t k)
{
  using Points = Hull_points_t<Object>;
  const Points& points = hull_points(object);
  std::array<Exact, hull_dimension_v<Object>> x;
  for(int axis = 0; axis < hull_dimension_v<Object>; ++axis)
    x[axis] = to_exact<Exact>(
      coordinate(vertex_of(points, place_of_vertex<Points, hull_size_v<Object>>(k, axis)), axis));
  return x;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_H
