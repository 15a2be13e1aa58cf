// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_TRIANGLES_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_TRIANGLES_INTERSECT_H

// Whether two triangles in space have more in common than the vertex or edge of a mesh that they
// share. No triangle is degenerate. The points are those of a kernel with exact predicates.

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/enum.h>
#include <CGAL/intersections.h>

#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

#include <array>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns a point in a kernel whose predicates are exact for it.
template <class Point>
auto with_exact_predicates(const Point& p)
{
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Exact_kernel = Kernel_with_exact_predicates<Kernel>;
  if constexpr(std::is_same_v<Kernel, Exact_kernel>)
    return p;
  else
    return Cartesian_converter<Kernel, Exact_kernel,
                               Convert_exactly<typename Kernel::FT, typename Exact_kernel::FT>>()(
      p);
}

// Whether all of the triangle `b` is on one side of the plane of the triangle `a`.
template <class Point>
bool does_plane_miss(const std::array<Point, 3>& a, const std::array<Point, 3>& b)
{
  const Orientation side = orientation(a[0], a[1], a[2], b[0]);
  return side != COPLANAR && orientation(a[0], a[1], a[2], b[1]) == side
         && orientation(a[0], a[1], a[2], b[2]) == side;
}

// Triangles that share nothing. Planes that miss are found sooner here than in do_intersect().
template <class Point>
bool do_triangles_intersect(const std::array<Point, 3>& a, const std::array<Point, 3>& b)
{
  using Triangle = typename Kernel_traits<Point>::Kernel::Triangle_3;
  return !does_plane_miss(a, b) && !does_plane_miss(b, a)
         && do_intersect(Triangle(a[0], a[1], a[2]), Triangle(b[0], b[1], b[2]));
}

// The triangles p q a and p q b share the edge p q. The line of p and q is all that their planes
// have in common, unless they have one plane.
template <class Point>
bool do_triangles_at_edge_intersect(const Point& p, const Point& q, const Point& a, const Point& b)
{
  return orientation(p, q, a, b) == COPLANAR && coplanar_orientation(p, q, a, b) == POSITIVE;
}

// Whether a point p in the plane of v, a and b is in the cone of all v + s (a - v) + t (b - v),
// where s >= 0 and t >= 0.
template <class Point>
bool is_in_cone(const Point& v, const Point& a, const Point& b, const Point& p)
{
  return coplanar_orientation(v, a, b, p) != NEGATIVE
         && coplanar_orientation(v, b, a, p) != NEGATIVE;
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
template <class Point>
bool do_triangles_at_vertex_intersect(const Point& v, const Point& a, const Point& b,
                                      const Point& c, const Point& d)
{
  const Orientation abc = orientation(v, a, b, c);
  const Orientation abd = orientation(v, a, b, d);
  if(abc == COPLANAR && abd == COPLANAR)
    return is_in_cone(v, a, b, c) || is_in_cone(v, a, b, d) || is_in_cone(v, c, d, a);
  if(abc == abd)
    return false;
  const Orientation side = abd != COPLANAR ? abd : opposite(abc);
  return orientation(v, c, d, a) != opposite(side) && orientation(v, c, d, b) != side;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_TRIANGLES_INTERSECT_H
