// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_TRIANGLES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_TRIANGLES_H

// Whether two triangles in space have more in common than the vertex or edge of a mesh that they
// share. No triangle is degenerate.
//
// `Orientation` decides about points, as Staged_orientation does.

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/Staged_orientation.h>
#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/spatial_objects.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The triangles p q a and p q b share the edge p q. The line of p and q is all that their planes
// have in common, unless they have one plane.
template <class Orientation>
bool do_triangles_at_edge_intersect(Orientation& orientation, const typename Orientation::Point& p,
                                    const typename Orientation::Point& q,
                                    const typename Orientation::Point& a,
                                    const typename Orientation::Point& b)
{
  if(!are_level<Orientation>(p, a, b, q)
     && orientation.side(orientation.plane(p, q, a), b) != ZERO)
    return false;
  const auto seen = project_triangle<Orientation>(orientation, {p, q, a});
  const Projection<Orientation>& projection = seen->projection;
  return projection.orientation(p, q, a) == projection.orientation(p, q, b);
}

// Whether a point p in the plane of v, a and b is in the cone of all v + s (a - v) + t (b - v),
// where s >= 0 and t >= 0. The triangle v a b turns left.
template <class Orientation>
bool is_in_cone(const Projection<Orientation>& projection, const Simplex<Orientation, 3>& triangle,
                const typename Orientation::Point& p)
{
  const auto& [v, a, b] = triangle;
  return projection.orientation(v, a, p) != NEGATIVE && projection.orientation(v, p, b) != NEGATIVE;
}

// The triangles v a b and v c d are in one plane.
template <class Orientation>
bool do_cones_intersect(Orientation& orientation, const Simplex<Orientation, 3>& vab,
                        const Simplex<Orientation, 3>& vcd)
{
  const auto first = project_triangle<Orientation>(orientation, vab);
  const Projection<Orientation>& projection = first->projection;
  const auto second
    = counterclockwise<Orientation>(vcd, projection.orientation(vcd[0], vcd[1], vcd[2]));
  return is_in_cone(projection, first->triangle, vcd[1])
         || is_in_cone(projection, first->triangle, vcd[2])
         || is_in_cone(projection, second, vab[1]);
}

// Whether a plane across an axis, through v, has v a b on one side, strictly but for v, and v c d
// on the other side, or the other way round. Then they have nothing but v in common. This is so
// for most neighbors in a mesh, and comparisons tell.
template <class Orientation>
bool are_apart_along_an_axis(const Simplex<Orientation, 3>& vab, const Simplex<Orientation, 3>& vcd)
{
  for(int axis = 0; axis < 3; ++axis) {
    const auto side = [&](const auto& p) { return Orientation::compare(p, vab[0], axis); };
    const Sign a = side(vab[1]), b = side(vab[2]), c = side(vcd[1]), d = side(vcd[2]);
    if((a == b && a != ZERO && c != a && d != a) || (c == d && c != ZERO && a != c && b != c))
      return true;
  }
  return false;
}

// The triangles v a b and v c d share the vertex v. They are convex, and cones close to v. So they
// have more than v in common iff their cones have a ray in common.
//
// Let v be the origin, and |a b c| the determinant of three points. Then
//
//   |a b d| c - |a b c| d = |c d a| b - |c d b| a.
//
// If the two factors on the left have no sign in common with c and d on one side of the plane of a
// and b, this is the ray of the cone of c and d in that plane, or its opposite. The signs of the
// factors on the right tell whether it is in the cone of a and b.
//
// If all points are in one plane, a common part of the cones ends in rays of their sides. These are
// a and b, unless one of them is c or d.
template <class Orientation>
bool do_triangles_at_vertex_intersect(Orientation& orientation, const Simplex<Orientation, 3>& vab,
                                      const Simplex<Orientation, 3>& vcd)
{
  if(are_apart_along_an_axis<Orientation>(vab, vcd))
    return false;
  if(are_level<Orientation>(vab[0], vcd[1], vab[1], vab[2], vcd[2]))
    return do_cones_intersect(orientation, vab, vcd);
  const auto plane_ab = orientation.plane(vab[0], vab[1], vab[2]);
  const Sign abc = orientation.side(plane_ab, vcd[1]);
  const Sign abd = orientation.side(plane_ab, vcd[2]);
  if(abc == ZERO && abd == ZERO)
    return do_cones_intersect(orientation, vab, vcd);
  if(abc == abd)
    return false;
  const Sign side = abd != ZERO ? abd : opposite(abc);
  const auto plane_cd = orientation.plane(vcd[0], vcd[1], vcd[2]);
  return orientation.side(plane_cd, vab[1]) != opposite(side)
         && orientation.side(plane_cd, vab[2]) != side;
}

// ---- by vertices --------------------------------------------------------------------------------

// Whether the vertices of a face are on a line.
template <class Orientation>
bool is_degenerate_face(typename Orientation::template Vertices<3>& vertices)
{
  using Point = typename Orientation::Point;
  Orientation orientation(vertices);
  return !project_triangle<Orientation>(
    orientation, {Point(vertices[0]), Point(vertices[1]), Point(vertices[2])});
}

// Whether two faces have more in common than the vertices that they share. These come first, and
// then those of each face alone: `Count` of them in all.
template <class Orientation, std::size_t Count>
bool do_faces_intersect(typename Orientation::template Vertices<Count>& vertices)
{
  const auto p = [&](std::size_t k) { return typename Orientation::Point(vertices[k]); };
  using Triangle = Simplex<Orientation, 3>;
  const Triangle first = {p(0), p(1), p(2)};
  Orientation orientation(vertices);
  if constexpr(Count == 6)
    return do_intersect_in_space(orientation, first, Triangle{p(3), p(4), p(5)});
  else if constexpr(Count == 5)
    return do_triangles_at_vertex_intersect(orientation, first, Triangle{p(0), p(3), p(4)});
  else
    return do_triangles_at_edge_intersect(orientation, p(0), p(1), p(2), p(3));
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template bool is_degenerate_face<Staged_orientation<3>>(Staged_orientation<3>::Vertices<3>&);
extern template bool do_faces_intersect<Staged_orientation<3>, 4>(
  Staged_orientation<3>::Vertices<4>&);
extern template bool do_faces_intersect<Staged_orientation<3>, 5>(
  Staged_orientation<3>::Vertices<5>&);
extern template bool do_faces_intersect<Staged_orientation<3>, 6>(
  Staged_orientation<3>::Vertices<6>&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MESHES_MESH_TRIANGLES_H
