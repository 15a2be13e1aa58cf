// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H

// The vertices of kernel objects: how many there are, which of them have all coordinates, and what
// doubles hold of them. A point is its own vertex.

#include <CGAL/Dimension.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Iso_rectangle_2.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Segment_2.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/Triangle_2.h>
#include <CGAL/Triangle_3.h>

#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The number of vertices of a kernel object; 0 for other types.
template <class Object>
struct Vertex_count : std::integral_constant<int, 0> {};
template <class K>
struct Vertex_count<Point_2<K>> : std::integral_constant<int, 1> {};
template <class K>
struct Vertex_count<Point_3<K>> : std::integral_constant<int, 1> {};
template <class K>
struct Vertex_count<Segment_2<K>> : std::integral_constant<int, 2> {};
template <class K>
struct Vertex_count<Segment_3<K>> : std::integral_constant<int, 2> {};
template <class K>
struct Vertex_count<Triangle_2<K>> : std::integral_constant<int, 3> {};
template <class K>
struct Vertex_count<Triangle_3<K>> : std::integral_constant<int, 3> {};
template <class K>
struct Vertex_count<Iso_rectangle_2<K>> : std::integral_constant<int, 4> {};
template <class K>
struct Vertex_count<Iso_cuboid_3<K>> : std::integral_constant<int, 8> {};
template <class K>
struct Vertex_count<Tetrahedron_3<K>> : std::integral_constant<int, 4> {};

// Every so many vertices have all coordinates of the object. In iso-boxes these are two opposite
// vertices: 0 and 2, or 0 and 7.
template <class Object>
struct Vertex_step : std::integral_constant<int, 1> {};
template <class K>
struct Vertex_step<Iso_rectangle_2<K>> : std::integral_constant<int, 2> {};
template <class K>
struct Vertex_step<Iso_cuboid_3<K>> : std::integral_constant<int, 7> {};

// Whether an object is an iso-box, which is all that is between two opposite vertices.
template <class Object>
constexpr bool is_iso_box_v = Vertex_step<Object>::value != 1;

// How many vertices have all coordinates of an object.
template <class Object>
constexpr std::size_t corner_count_v
  = static_cast<std::size_t>((Vertex_count<Object>::value - 1) / Vertex_step<Object>::value + 1);

template <class K>
const Point_2<K>& vertex_of(const Point_2<K>& point, int)
{
  return point;
}
template <class K>
const Point_3<K>& vertex_of(const Point_3<K>& point, int)
{
  return point;
}
template <class Object>
decltype(auto) vertex_of(const Object& object, int v)
{
  return object.vertex(v);
}

// The dimension of the vertices of an object.
template <class Object>
constexpr int vertex_dimension_v
  = Ambient_dimension<std::decay_t<decltype(vertex_of(std::declval<const Object&>(), 0))>>::value;

// The objects of lazy kernels hold intervals of the coordinates of their vertices. A vertex of such
// an object would be a new lazy point, with memory of its own.
template <class Object, class = void>
struct Has_approximate_vertices : std::false_type {};
template <class Object>
struct Has_approximate_vertices<
  Object, std::void_t<decltype(std::declval<const Object&>().approx().vertex(0).cartesian(0))>>
  : std::true_type {};

// Returns doubles that enclose coordinate i of a vertex.
template <class Object>
std::pair<double, double> vertex_bounds(const Object& object, int v, int i)
{
  if constexpr(Has_approximate_vertices<Object>::value) {
    const auto x = object.approx().vertex(v).cartesian(i);
    return {x.inf(), x.sup()};
  }
  else
    return coordinate_bounds(vertex_of(object, v), i);
}

// The doubles of the vertices that have all coordinates of an object.
template <class Object>
using Vertex_doubles
  = std::array<std::array<double, static_cast<std::size_t>(vertex_dimension_v<Object>)>,
               corner_count_v<Object>>;

// Reads the vertices of an object. Returns false if a coordinate is no double.
template <class Object>
bool read_vertices(const Object& object, Vertex_doubles<Object>& vertices)
{
  int v = 0;
  for(auto& vertex : vertices) {
    for(int i = 0; i < vertex_dimension_v<Object>; ++i) {
      const std::pair<double, double> x = vertex_bounds(object, v, i);
      if(x.first != x.second)
        return false;
      vertex[i] = x.first;
    }
    v += Vertex_step<Object>::value;
  }
  return true;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H
