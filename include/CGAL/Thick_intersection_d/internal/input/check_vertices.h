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

// Returns whether the bounding box of an object is the object.
template <class Object>
constexpr bool is_box_of_doubles()
{
  if constexpr(Vertex_count<Object>::value == 1 || is_iso_box_v<Object>)
    return has_double_vertices_v<Object>;
  else
    return std::is_same_v<Object, Bbox_2> || std::is_same_v<Object, Bbox_3>;
}

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
