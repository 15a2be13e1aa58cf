// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H

// The vertices of kernel objects: how many there are, which of them have all coordinates, and what
// doubles hold of them. A point is its own vertex.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Iso_rectangle_2.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Segment_2.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/Triangle_2.h>
#include <CGAL/Triangle_3.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Every so many vertices have all coordinates of the object. In iso-boxes these are two opposite
// vertices: 0 and 2, or 0 and 7.
template <class Object>
struct Vertex_step : std::integral_constant<int, 1> {};
template <class K>
struct Vertex_step<Iso_rectangle_2<K>> : std::integral_constant<int, 2> {};
template <class K>
struct Vertex_step<Iso_cuboid_3<K>> : std::integral_constant<int, 7> {};
template <>
struct Vertex_step<Bbox_2> : std::integral_constant<int, 2> {};
template <>
struct Vertex_step<Bbox_3> : std::integral_constant<int, 7> {};

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
// The first and the last corner of a Bbox.
inline Simple_cartesian<double>::Point_2 vertex_of(const Bbox_2& box, int v)
{
  return v == 0 ? Simple_cartesian<double>::Point_2(box.xmin(), box.ymin())
                : Simple_cartesian<double>::Point_2(box.xmax(), box.ymax());
}
inline Simple_cartesian<double>::Point_3 vertex_of(const Bbox_3& box, int v)
{
  return v == 0 ? Simple_cartesian<double>::Point_3(box.xmin(), box.ymin(), box.zmin())
                : Simple_cartesian<double>::Point_3(box.xmax(), box.ymax(), box.zmax());
}
template <class Object>
decltype(auto) vertex_of(const Object& object, int v)
{
  return object.vertex(v);
}

template <class Object>
using Vertex_t = std::decay_t<decltype(vertex_of(std::declval<const Object&>(), 0))>;

// The dimension of the vertices of an object.
template <class Object>
constexpr int vertex_dimension_v = Ambient_dimension<Vertex_t<Object>>::value;

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

// The number type of the coordinates of an object.
template <class Object>
using Vertex_number_t = typename Kernel_traits<Vertex_t<Object>>::Kernel::FT;

// Whether the coordinates of an object are doubles, by their type.
template <class Object>
constexpr bool has_double_vertices_v = is_held_by_double_v<Vertex_number_t<Object>>;

// Returns which vertex of an object has coordinate `axis` of the k-th of `Count` vertices. An
// iso-box has either two, which are opposite, or all, which are numbered by bits: bit `axis` is set
// at the upper end along that axis.
template <class Object, std::size_t Count>
constexpr int place_of_vertex(std::size_t k, int axis)
{
  if constexpr(Count == corner_count_v<Object>)
    return static_cast<int>(k) * Vertex_step<Object>::value;
  else
    return static_cast<int>(k >> axis & 1) * Vertex_step<Object>::value;
}

// Calls put(k, axis, x) for the coordinates of `Count` vertices of an object, by default those that
// have all its coordinates. Returns false if one of them is no double.
template <std::size_t Count, class Object, class Function>
bool read_vertices(const Object& object, const Function& put)
{
  for(std::size_t k = 0; k < Count; ++k)
    for(int axis = 0; axis < vertex_dimension_v<Object>; ++axis) {
      const int v = place_of_vertex<Object, Count>(k, axis);
      if constexpr(has_double_vertices_v<Object>)
        put(k, axis, static_cast<double>(coordinate(vertex_of(object, v), axis)));
      else {
        const std::pair<double, double> x = vertex_bounds(object, v, axis);
        if(x.first != x.second)
          return false;
        put(k, axis, x.first);
      }
    }
  return true;
}
template <class Object, class Function>
bool read_vertices(const Object& object, const Function& put)
{
  return read_vertices<corner_count_v<Object>>(object, put);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H
