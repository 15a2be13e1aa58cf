// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_OPEN_TETRAHEDRA_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_OPEN_TETRAHEDRA_H

// Does the interior of a tetrahedron meet another object in space? Vertices and edges that are in
// no plane of a face, and cross no edge, decide at once. Otherwise planes between the two are
// looked for, as interiors.h says.

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/tetrahedra.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether a line or plane is between two objects. `side` tells on which side of it a vertex is. It
// is none if all vertices are on it: then the points that it goes through are on a line, or are one
// point.
template <class Side, class Vertices_a, class Vertices_b>
bool is_between(const Side& side, const Vertices_a& a, const Vertices_b& b)
{
  bool is_a_above = false, is_a_below = false;
  for(const auto& p : a) {
    const Sign sign = side(p);
    is_a_above |= sign == POSITIVE;
    is_a_below |= sign == NEGATIVE;
    if(is_a_above && is_a_below)
      return false;
  }
  for(const auto& p : b) {
    const Sign sign = side(p);
    is_a_below |= sign == POSITIVE; // or on the line or plane
    is_a_above |= sign == NEGATIVE;
    if(is_a_above && is_a_below)
      return false;
  }
  return is_a_above || is_a_below;
}

// Whether one of several points is the vertex itself. Nothing has to be computed then.
template <class Point, class... Points>
bool is_any_of(const Point& vertex, const Points&... points)
{
  return ((&vertex == &points) || ...);
}

// Whether the line from p to q goes through a triangle; nothing is known if it meets the boundary.
template <class Orientation>
Uncertain<bool> does_line_cross(Orientation& orientation, const typename Orientation::Point& p,
                                const typename Orientation::Point& q,
                                const Simplex<Orientation, 3>& triangle)
{
  const Sign a = orientation.side(orientation.plane(p, q, triangle[0]), triangle[1]);
  const Sign b = orientation.side(orientation.plane(p, q, triangle[1]), triangle[2]);
  if(a * b < 0)
    return false;
  const Sign c = orientation.side(orientation.plane(p, q, triangle[2]), triangle[0]);
  if(a * c < 0 || b * c < 0)
    return false;
  return a != ZERO && b != ZERO && c != ZERO ? Uncertain<bool>(true)
                                             : Uncertain<bool>::indeterminate();
}

// Whether an edge of an object crosses a face of a tetrahedron, along whose faces its vertices have
// these sides.
template <class Orientation, std::size_t Count>
Uncertain<bool> do_edges_cross(Orientation& orientation, const Simplex<Orientation, Count>& object,
                               const Sides_of_faces<Count>& sides,
                               const Simplex<Orientation, 4>& tetrahedron)
{
  Uncertain<bool> do_cross(false, sides.is_any_on);
  for(std::size_t i = 0; i < Count; ++i)
    for(std::size_t j = i + 1; j < Count; ++j)
      for(std::size_t k = 0; k < 4 && (sides.outside[i] & sides.outside[j]) == 0; ++k)
        if(sides.sides[k][i] * sides.sides[k][j] < 0) {
          do_cross = do_cross | does_line_cross(orientation, object[i], object[j],
                                                face_of<Orientation>(tetrahedron, k));
          if(do_cross.inf())
            return true;
        }
  return do_cross;
}

// Whether an edge of a tetrahedron crosses a triangle. Vertices of it in the plane of the triangle
// leave nothing open. If the plane meets the interior, edges cross it. If none does so in the
// triangle, that has not all of what the plane cuts out of the tetrahedron. So where it meets the
// interior, an edge of it crosses a face, or a vertex of it is inside.
template <class Orientation>
Uncertain<bool> do_edges_cross(Orientation& orientation, const Simplex<Orientation, 4>& tetrahedron,
                               const Simplex<Orientation, 3>& triangle)
{
  const auto plane = orientation.plane(triangle[0], triangle[1], triangle[2]);
  std::array<Sign, 4> sides;
  for(std::size_t i = 0; i < 4; ++i)
    sides[i] = orientation.side(plane, tetrahedron[i]);
  Uncertain<bool> do_cross = false;
  for(std::size_t i = 0; i < 4; ++i)
    for(std::size_t j = i + 1; j < 4; ++j)
      if(sides[i] * sides[j] < 0)
        do_cross
          = do_cross | does_line_cross(orientation, tetrahedron[i], tetrahedron[j], triangle);
  return do_cross;
}

// Whether a vertex or edge shows that the interior of a tetrahedron meets an object, which may be
// an open tetrahedron. If none does, and no vertex or edge is on a plane or edge of the other
// object, they are apart, as tetrahedra.h says.
template <class Orientation, std::size_t Count>
Uncertain<bool> does_interior_certainly_meet(Orientation& orientation,
                                             const Simplex<Orientation, 4>& tetrahedron, Sign sign,
                                             const Simplex<Orientation, Count>& object,
                                             [[maybe_unused]] bool is_object_open)
{
  const auto sides = sides_of_faces(orientation, tetrahedron, sign, true, object);
  if(sides.is_face_between())
    return false;
  if constexpr(Count < 4) {
    if(sides.is_any_inside())
      return true;
    const Uncertain<bool> do_cross = do_edges_cross(orientation, object, sides, tetrahedron);
    if constexpr(Count == 3)
      if(!do_cross.inf())
        return do_cross | do_edges_cross(orientation, tetrahedron, object);
    return do_cross;
  }
  else {
    const Sign sign_of_object = orientation_of(orientation, object);
    if(is_object_open && sign_of_object == ZERO)
      return false;
    if(sides.is_any_inside())
      return true;
    if(sign_of_object == ZERO)
      return Uncertain<bool>::indeterminate();
    const auto other_sides
      = sides_of_faces(orientation, object, sign_of_object, true, tetrahedron);
    if(other_sides.is_face_between())
      return false;
    if(other_sides.is_any_inside())
      return true;
    const Uncertain<bool> do_cross = do_edges_cross(orientation, object, sides, tetrahedron);
    if(do_cross.inf())
      return true;
    return do_cross | do_edges_cross(orientation, tetrahedron, other_sides, object);
  }
}

// Whether a plane through three vertices is between a tetrahedron and another object.
template <class Orientation, std::size_t Count>
bool is_plane_of_vertices_between(Orientation& orientation,
                                  const Simplex<Orientation, 4>& tetrahedron,
                                  const Simplex<Orientation, Count>& object)
{
  const auto vertex = [&](std::size_t k) -> const auto& {
    return k < 4 ? tetrahedron[k] : object[k - 4];
  };
  for(std::size_t i = 0; i < 4 + Count; ++i)
    for(std::size_t j = i + 1; j < 4 + Count; ++j)
      for(std::size_t k = j + 1; k < 4 + Count; ++k) {
        const auto plane = orientation.plane(vertex(i), vertex(j), vertex(k));
        const auto side = [&](const auto& x) {
          return is_any_of(x, vertex(i), vertex(j), vertex(k)) ? ZERO : orientation.side(plane, x);
        };
        if(is_between(side, tetrahedron, object))
          return true;
      }
  return false;
}

// Whether the interior of a tetrahedron meets an object, or the interior of another tetrahedron.
template <class Orientation, std::size_t Count>
bool does_interior_meet(Orientation& orientation, const Simplex<Orientation, 4>& tetrahedron,
                        const Simplex<Orientation, Count>& object, bool is_object_open)
{
  const Sign sign = orientation_of(orientation, tetrahedron);
  if(sign == ZERO)
    return false;
  const Uncertain<bool> does_meet
    = does_interior_certainly_meet(orientation, tetrahedron, sign, object, is_object_open);
  return is_certain(does_meet) ? get_certain(does_meet)
                               : !is_plane_of_vertices_between(orientation, tetrahedron, object);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_OPEN_TETRAHEDRA_H
