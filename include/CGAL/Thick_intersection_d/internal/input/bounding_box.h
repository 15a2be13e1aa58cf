// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H

// The bounding box of an object.

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/vertices.h>

#include <cmath>
#include <type_traits>

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

template <class Object>
auto bounding_box_of_vertices(const Object& object)
{
  using Box = decltype(object.bbox());
  Box box;
  for(int v = 0; v < Vertex_count<Object>::value; v += Vertex_step<Object>::value)
    box = box + bounding_box_of_point<Box>(object.vertex(v));
  return box;
}

// Whether coordinates are quotients, as in homogeneous kernels.
template <class Object>
constexpr bool has_quotient_vertices()
{
  if constexpr(Vertex_count<Object>::value == 0)
    return false;
  else
    return Is_quotient<typename Kernel_traits<Object>::Kernel::FT>::value;
}

// CGAL divides bounds of numerators by bounds of denominators. This gives an infinite box if a
// denominator is beyond the doubles, though the quotients are not.
template <class Object>
auto bounding_box(const Object& object)
{
  auto box = object.bbox();
  if constexpr(has_quotient_vertices<Object>())
    if(!is_finite_box(box))
      return bounding_box_of_vertices(object);
  return box;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_BOUNDING_BOX_H
