// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TETRAHEDRA_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TETRAHEDRA_H

// Do closed tetrahedra in space intersect? They may be degenerate: then a tetrahedron is the union
// of its four triangles, which may be degenerate themselves.
//
// `Orientation` decides about points, as Staged_orientation does.
//
// Let two tetrahedra that are not degenerate intersect. Then one has a vertex in the other, or one
// has an edge that crosses a face of the other, with its ends on different sides of the face, both
// not in its plane. For their intersection has a vertex. It is a vertex of one of them, or lies
// within an edge of one and a face of the other that are in no plane, or within two edges. In the
// last case let the edge e cross the edge f. If e is in the plane of neither face at f, it crosses
// these faces. If it is in the plane of one, follow e into this face. It ends there, or leaves the
// face across another edge, or at a vertex; it is not in the plane of the other face there.

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Face k of a tetrahedron has all vertices but vertex k. If the orientation of the vertices is
// positive, so is the side of vertex k along face k.
constexpr std::size_t face_vertices[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

template <class Orientation>
Simplex<Orientation, 3> face_of(const Simplex<Orientation, 4>& tetrahedron, std::size_t k)
{
  const std::size_t* const v = face_vertices[k];
  return {tetrahedron[v[0]], tetrahedron[v[1]], tetrahedron[v[2]]};
}

// Returns the orientation of the vertices of a tetrahedron: zero if it is degenerate.
template <class Orientation>
Sign orientation_of(Orientation& orientation, const Simplex<Orientation, 4>& t)
{
  return orientation.side(orientation.plane(t[0], t[1], t[2]), t[3]);
}

// Where the vertices of an object are along the faces of a tetrahedron.
template <std::size_t Count>
struct Sides_of_faces
{
  Sign sides[4][Count];                // of a face and a vertex
  std::array<int, Count> outside = {}; // of a vertex: bit k is set if it is outside of face k
  bool is_any_on = false;              // the plane of a face

  bool is_any_inside() const
  {
    for(const int faces : outside)
      if(faces == 0)
        return true;
    return false;
  }
  bool is_face_between() const
  {
    int faces = 15;
    for(const int k : outside)
      faces &= k;
    return faces != 0;
  }
};

// Stops at the first face that has all vertices outside. The tetrahedron has faces of the
// orientation `sign`. If it is open, vertices in the plane of a face are outside of the face.
template <class Orientation, std::size_t Count>
Sides_of_faces<Count>
sides_of_faces(Orientation& orientation, const Simplex<Orientation, 4>& tetrahedron, Sign sign,
               bool is_open, const Simplex<Orientation, Count>& vertices)
{
  Sides_of_faces<Count> result;
  for(std::size_t k = 0; k < 4 && !result.is_face_between(); ++k) {
    const std::size_t* const v = face_vertices[k];
    const auto plane
      = orientation.plane(tetrahedron[v[0]], tetrahedron[v[1]], tetrahedron[v[2]]);
    for(std::size_t i = 0; i < Count; ++i) {
      const Sign side = orientation.side(plane, vertices[i]);
      const bool is_outside = is_open ? side != sign : side == opposite(sign);
      result.sides[k][i] = side;
      result.outside[i] |= static_cast<int>(is_outside) << k;
      result.is_any_on |= side == ZERO;
    }
  }
  return result;
}

// Whether an edge of tetrahedron `a`, whose vertices have these sides, crosses a face of `b`.
template <class Orientation>
bool does_any_edge_cross(Orientation& orientation, const Sides_of_faces<4>& sides,
                         const Simplex<Orientation, 4>& a, const Simplex<Orientation, 4>& b)
{
  for(std::size_t i = 0; i < 4; ++i)
    for(std::size_t j = i + 1; j < 4; ++j)
      for(std::size_t k = 0; k < 4 && (sides.outside[i] & sides.outside[j]) == 0; ++k)
        if(sides.sides[k][i] * sides.sides[k][j] < 0
           && does_line_meet_triangle(orientation, a[i], a[j], face_of<Orientation>(b, k)))
          return true;
  return false;
}

// Neither is degenerate.
template <class Orientation>
bool do_tetrahedra_intersect(Orientation& orientation, const Simplex<Orientation, 4>& a,
                             Sign sign_a, const Simplex<Orientation, 4>& b, Sign sign_b)
{
  const Sides_of_faces<4> sides_a = sides_of_faces(orientation, b, sign_b, false, a);
  if(sides_a.is_face_between())
    return false;
  const Sides_of_faces<4> sides_b = sides_of_faces(orientation, a, sign_a, false, b);
  if(sides_b.is_face_between())
    return false;
  return sides_a.is_any_inside() || sides_b.is_any_inside()
         || does_any_edge_cross(orientation, sides_a, a, b)
         || does_any_edge_cross(orientation, sides_b, b, a);
}

template <class Orientation>
bool is_in_tetrahedron(Orientation& orientation, const Simplex<Orientation, 4>& tetrahedron,
                       Sign sign, const typename Orientation::Point& p)
{
  const Simplex<Orientation, 1> vertex = {p};
  return sides_of_faces(orientation, tetrahedron, sign, false, vertex).is_any_inside();
}

// Whether an object, a triangle or segment, meets one of the faces.
template <class Orientation, std::size_t Count>
bool does_meet_faces(Orientation& orientation, const Simplex<Orientation, Count>& object,
                     const Simplex<Orientation, 4>& tetrahedron)
{
  for(std::size_t k = 0; k < 4; ++k)
    if(do_intersect_in_space(orientation, object, face_of<Orientation>(tetrahedron, k)))
      return true;
  return false;
}

// A triangle or segment in a tetrahedron has its vertices there. One that is not meets a face.
template <class Orientation, std::size_t Count>
bool do_intersect_in_space(Orientation& orientation, const Simplex<Orientation, Count>& object,
                           const Simplex<Orientation, 4>& tetrahedron)
{
  const Sign sign = orientation_of(orientation, tetrahedron);
  return (sign != ZERO && is_in_tetrahedron(orientation, tetrahedron, sign, object[0]))
         || does_meet_faces(orientation, object, tetrahedron);
}

template <class Orientation>
bool do_intersect_in_space(Orientation& orientation, const Simplex<Orientation, 4>& a,
                           const Simplex<Orientation, 4>& b)
{
  const Sign sign_a = orientation_of(orientation, a), sign_b = orientation_of(orientation, b);
  if(sign_a != ZERO && sign_b != ZERO)
    return do_tetrahedra_intersect(orientation, a, sign_a, b, sign_b);
  const auto& degenerate = sign_a == ZERO ? a : b;
  const auto& other = sign_a == ZERO ? b : a;
  for(std::size_t k = 0; k < 4; ++k)
    if(do_intersect_in_space(orientation, face_of<Orientation>(degenerate, k), other))
      return true;
  return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TETRAHEDRA_H
