// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_CHECK_VERTICES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_CHECK_VERTICES_H

// Checks that the vertices of kernel objects are finite. Bounding boxes do not show this, because
// the minimum of NaN and 1 may be 1.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Circle_2.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Iso_rectangle_2.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Sphere_3.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Object>
struct Is_hypersphere : std::false_type {};
template <class K>
struct Is_hypersphere<Circle_2<K>> : std::true_type {};
template <class K>
struct Is_hypersphere<Sphere_3<K>> : std::true_type {};

// Whether the bounding box of an object is the object.
template <class Object>
struct Is_box_of_doubles : std::false_type {};
template <class K>
struct Is_box_of_doubles<Point_2<K>> : std::bool_constant<is_held_by_double_v<typename K::FT>>
{};
template <class K>
struct Is_box_of_doubles<Point_3<K>> : std::bool_constant<is_held_by_double_v<typename K::FT>>
{};
template <class K>
struct Is_box_of_doubles<Iso_rectangle_2<K>>
  : std::bool_constant<is_held_by_double_v<typename K::FT>>
{};
template <class K>
struct Is_box_of_doubles<Iso_cuboid_3<K>>
  : std::bool_constant<is_held_by_double_v<typename K::FT>>
{};
template <>
struct Is_box_of_doubles<Bbox_2> : std::true_type {};
template <>
struct Is_box_of_doubles<Bbox_3> : std::true_type {};

// Throws if the box of an object is not finite. That of an empty Bbox begins behind its end.
template <class Object>
void check_bounding_box(const Object& object, std::size_t position)
{
  const auto& box = bounding_box(object);
  for(int i = 0; i < box.dimension(); ++i)
    if(!(std::isfinite((box.min)(i)) && std::isfinite((box.max)(i))
         && (box.min)(i) <= (box.max)(i)))
      throw std::invalid_argument("The bounding box of object " + std::to_string(position)
                                  + " is empty or not finite.");
}

// Throws if a coordinate of a vertex is NaN or infinite.
template <class Object>
void check_vertices(const Object& object, std::size_t position)
{
  if constexpr(Vertex_count<Object>::value == 0)
    check_bounding_box(object, position);
  else
    for(int v = 0; v < Vertex_count<Object>::value; v += Vertex_step<Object>::value)
      for(int i = 0; i < vertex_dimension_v<Object>; ++i)
        if(!are_bounds_of_finite(vertex_bounds(object, v, i)))
          throw_not_finite("vertex of object", position, i);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_CHECK_VERTICES_H
