// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H

// How many vertices kernel objects have, and which of them have all coordinates.

#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Iso_rectangle_2.h>
#include <CGAL/Segment_2.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/Triangle_2.h>
#include <CGAL/Triangle_3.h>

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The number of vertices of a kernel object; 0 for other types.
template <class Object>
struct Vertex_count : std::integral_constant<int, 0> {};
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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_VERTICES_H
