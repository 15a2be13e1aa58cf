// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTERIORS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTERIORS_H

// Do two objects intersect of which one is open, without its boundary, or both are?
//
// `Orientation` decides about points, as Staged_orientation does.
//
// Let A and B be convex, and let A have an interior. It does not meet B iff a plane is between
// them: A is on one side and B on the other, where both may touch the plane. If B has an interior
// too, this is so iff the two interiors do not meet. So the question is the same whether B is open
// or closed, and an open object without interior meets nothing.
//
// Which planes to try? Planes between A and B are the points of a cone: their coefficients satisfy
// a linear inequality for each vertex. The vertices are in no common plane, because A has an
// interior. So the cone has extreme rays, and each of these planes goes through three vertices, of
// A or B, that are on no line. In the plane, lines through two vertices of one object are enough,
// and for iso-boxes the planes in iso_boxes.h are: the Minkowski difference of A and B is not
// degenerate, and one of its facets is towards the origin, or has it.

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/do_shapes_intersect.h>
#include <CGAL/Thick_intersection_d/internal/predicates/iso_boxes.h>
#include <CGAL/Thick_intersection_d/internal/predicates/open_tetrahedra.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// ---- lines --------------------------------------------------------------------------------------

// Whether a line through two vertices of an object is between it and another one, in the projection
// along the axes i and j.
template <class Orientation, std::size_t Count, class Vertices>
bool is_edge_between(Orientation& orientation, const Simplex<Orientation, Count>& object,
                     const Vertices& other, int i, int j)
{
  for(std::size_t k = 0; k < Count; ++k)
    for(std::size_t l = k + 1; l < Count; ++l) {
      const auto& p = object[k];
      const auto& q = object[l];
      const auto side = [&](const auto& x) {
        return is_any_of(x, p, q) ? ZERO : orientation.orientation(p, q, x, i, j);
      };
      if(is_between(side, object, other))
        return true;
    }
  return false;
}

// Whether an edge of a triangle in the plane is between it and another object. The vertices have
// the orientation `sign`.
template <class Orientation, std::size_t Count>
bool is_edge_of_triangle_between(Orientation& orientation, const Simplex<Orientation, 3>& triangle,
                                 Sign sign, const Simplex<Orientation, Count>& other)
{
  if(sign == ZERO)
    return is_edge_between(orientation, triangle, other, 0, 1);
  for(std::size_t k = 0; k < 3; ++k) {
    const auto& p = triangle[k];
    const auto& q = triangle[k < 2 ? k + 1 : 0];
    std::array<Sign, Count> sides;
    bool is_any_inside = false; // no branch depends on which vertex it is
    for(std::size_t i = 0; i < Count; ++i) {
      sides[i] = orientation.orientation_by_filter(p, q, other[i], 0, 1);
      is_any_inside |= sides[i] == sign;
    }
    for(std::size_t i = 0; i < Count && !is_any_inside; ++i)
      is_any_inside = sides[i] == ZERO
                      && orientation.decide_orientation(p, q, other[i], 0, 1) == sign;
    if(!is_any_inside)
      return true;
  }
  return false;
}

// The two objects are in the plane, the second one is a triangle, and one of them is open.
template <class Orientation, std::size_t Count>
bool do_open_triangles_intersect(Orientation& orientation, const Simplex<Orientation, Count>& a,
                                 const Simplex<Orientation, 3>& b, bool is_a_open, bool is_b_open)
{
  const auto sign_of = [&](const Simplex<Orientation, 3>& t) {
    return orientation.orientation(t[0], t[1], t[2], 0, 1);
  };
  const Sign sign_b = sign_of(b);
  if(is_b_open && sign_b == ZERO)
    return false;
  if constexpr(Count == 3) {
    const Sign sign_a = sign_of(a);
    if((is_a_open && sign_a == ZERO) || is_edge_of_triangle_between(orientation, a, sign_a, b))
      return false;
  }
  else if(is_edge_between(orientation, a, b, 0, 1))
    return false;
  return !is_edge_of_triangle_between(orientation, b, sign_b, a);
}

// ---- iso-boxes ----------------------------------------------------------------------------------

// Whether a plane of a face across an axis is between a box and another object.
template <class Orientation, class Box, class Vertices>
bool is_box_face_between(const Box& box, const Vertices& other, int axis)
{
  for(const auto& corner : {box.front(), box.back()})
    if(is_between([&](const auto& p) { return Orientation::compare(p, corner, axis); },
                  std::array{box.front(), box.back()}, other))
      return true;
  return false;
}

template <class Orientation, std::size_t Count>
bool is_plane_of_box_between(Orientation& orientation, const Simplex<Orientation, Count>& object,
                             const Box_corners<Orientation>& box)
{
  if constexpr(Count < 3)
    return false;
  else {
    constexpr std::size_t faces = Count == 3 ? 1 : 4;
    for(std::size_t k = 0; k < faces; ++k) {
      const std::size_t* const v = face_vertices[Count == 3 ? 3 : k];
      const auto plane = orientation.plane(object[v[0]], object[v[1]], object[v[2]]);
      const auto side = [&](const auto& x) {
        return is_any_of(x, object[v[0]], object[v[1]], object[v[2]])
                 ? ZERO : orientation.side(plane, x);
      };
      if(is_between(side, object, box))
        return true;
    }
    return false;
  }
}

template <class Orientation, std::size_t Count>
bool are_box_and_object_parted(Orientation& orientation, const Simplex<Orientation, Count>& object,
                               const Box_corners<Orientation>& box)
{
  for(int axis = 0; axis < Orientation::dimension; ++axis)
    if(is_box_face_between<Orientation>(box, object, axis))
      return true;
  if constexpr(Orientation::dimension == 2)
    return is_edge_between(orientation, object, box, 0, 1);
  else {
    for(int axis = 0; axis < 3; ++axis)
      if(is_edge_between(orientation, object, box, (axis + 1) % 3, (axis + 2) % 3))
        return true;
    return is_plane_of_box_between(orientation, object, box);
  }
}

// ---- all shapes ---------------------------------------------------------------------------------

// Whether an object is not degenerate, and of a shape that has an interior then.
template <Shape A, class Orientation, std::size_t Count>
bool has_interior([[maybe_unused]] Orientation& orientation,
                  [[maybe_unused]] const Simplex<Orientation, Count>& vertices)
{
  if constexpr(A == Shape::ISO_BOX) {
    for(int axis = 0; axis < Orientation::dimension; ++axis)
      if(Orientation::compare(vertices.front(), vertices.back(), axis) != NEGATIVE)
        return false;
    return true;
  }
  else if constexpr(A == Shape::TETRAHEDRON)
    return orientation_of(orientation, vertices) != ZERO;
  else if constexpr(A == Shape::TRIANGLE && Orientation::dimension == 2)
    return orientation.orientation(vertices[0], vertices[1], vertices[2], 0, 1) != ZERO;
  else
    return false;
}

// As do_shapes_intersect().
template <Shape A, Shape B, class Orientation, std::size_t Count_a, std::size_t Count_b>
bool do_open_shapes_intersect(Orientation& orientation, const Simplex<Orientation, Count_a>& a,
                              const Simplex<Orientation, Count_b>& b, bool is_a_open,
                              bool is_b_open)
{
  if constexpr(B == Shape::TRIANGLE && Orientation::dimension == 2)
    return do_open_triangles_intersect(orientation, a, b, is_a_open, is_b_open);
  else if constexpr(B == Shape::TETRAHEDRON) {
    if constexpr(A == Shape::TETRAHEDRON)
      if(is_a_open)
        return does_interior_meet(orientation, a, b, is_b_open);
    return !is_a_open && does_interior_meet(orientation, b, a, false);
  }
  else if((is_a_open && !has_interior<A>(orientation, a))
          || (is_b_open && !has_interior<B>(orientation, b)))
    return false;
  if constexpr(B == Shape::ISO_BOX && (A == Shape::POINT || A == Shape::ISO_BOX)) {
    for(int axis = 0; axis < Orientation::dimension; ++axis)
      if(is_box_face_between<Orientation>(b, a, axis))
        return false;
    return true;
  }
  else if constexpr(B == Shape::ISO_BOX)
    return !are_box_and_object_parted(orientation, a, b);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTERIORS_H
