// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SPATIAL_OBJECTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SPATIAL_OBJECTS_H

// Do closed segments and triangles in space intersect? They may be degenerate: a segment may be a
// point, and a triangle a segment or a point.
//
// `Orientation` decides about points, as Staged_orientation does.

#include <CGAL/enum.h>

#include <CGAL/Thick_intersection_d/internal/predicates/planar_objects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The projection along one of the three axes.
template <class Orientation>
Projection<Orientation> projection_along(Orientation& orientation, int axis)
{
  return {orientation, (axis + 1) % 3, (axis + 2) % 3};
}

// A triangle that is not degenerate, seen along an axis along which its projection is not
// degenerate either. So the projections of two sets in its plane intersect iff the sets do.
template <class Orientation>
struct Projected_triangle
{
  Projection<Orientation> projection;
  Simplex<Orientation, 3> triangle; // it turns left there
};

// Returns nothing if the triangle is degenerate. Floors are not degenerate along the last axis.
template <class Orientation>
std::optional<Projected_triangle<Orientation>>
project_triangle(Orientation& orientation, const Simplex<Orientation, 3>& triangle)
{
  for(int axis = 2; axis >= 0; --axis) {
    const Projection<Orientation> projection = projection_along(orientation, axis);
    const Sign side = projection.orientation(triangle[0], triangle[1], triangle[2]);
    if(side != ZERO)
      return Projected_triangle<Orientation>{projection,
                                             counterclockwise<Orientation>(triangle, side)};
  }
  return std::nullopt;
}

// Segments intersect iff they are in a plane and their projections along all axes intersect. If the
// plane is theirs alone, their projection along one of the axes is like them. If they are on a
// line, all projections are, and these ask whether the boxes meet. Projections cost less than to
// tell whether segments that are nearly in a plane are in it.
template <class Orientation>
bool do_intersect_in_space(Orientation& orientation, const Simplex<Orientation, 2>& a,
                           const Simplex<Orientation, 2>& b)
{
  const auto plane = orientation.plane(a[0], a[1], b[0]);
  if(orientation.side_by_filter(plane, b[1]) != ZERO)
    return false;
  for(int axis = 0; axis < 3; ++axis)
    if(!do_segments_intersect(projection_along(orientation, axis), a, b))
      return false;
  return orientation.decide_side(plane, b[1]) == ZERO;
}

// ---- a segment and a triangle -------------------------------------------------------------------

// Whether the line from p to q meets a triangle that is in no plane with it: it passes all edges on
// one side.
template <class Orientation>
bool does_line_meet_triangle(Orientation& orientation, const typename Orientation::Point& p,
                             const typename Orientation::Point& q,
                             const Simplex<Orientation, 3>& triangle)
{
  Sign side = ZERO;
  for(std::size_t k = 0; k < 3; ++k) {
    const Sign of_edge
      = orientation.side(orientation.plane(p, q, triangle[k]), triangle[(k + 1) % 3]);
    if(of_edge != ZERO && side != ZERO && of_edge != side)
      return false;
    side = of_edge != ZERO ? of_edge : side;
  }
  return true;
}

template <class Orientation>
bool do_intersect_in_space(Orientation& orientation, const Simplex<Orientation, 2>& segment,
                           const Simplex<Orientation, 3>& triangle)
{
  const auto plane = orientation.plane(triangle[0], triangle[1], triangle[2]);
  const Sign p = orientation.side(plane, segment[0]), q = orientation.side(plane, segment[1]);
  if(p == q && p != ZERO)
    return false;
  if(p != ZERO || q != ZERO)
    return does_line_meet_triangle(orientation, segment[0], segment[1], triangle);
  if(const auto projection = project_triangle(orientation, triangle))
    return does_segment_meet_triangle(projection->projection, segment, projection->triangle);
  return do_intersect_in_space(orientation, segment, segment_of_degenerate<Orientation>(triangle));
}

// ---- two triangles ------------------------------------------------------------------------------

inline bool are_all(const std::array<Sign, 3>& signs, Sign sign)
{
  return signs[0] == sign && signs[1] == sign && signs[2] == sign;
}

// Whether the projections of two triangles intersect. Returns nothing if one of them is degenerate
// there. If the triangles are in one plane, they intersect iff their projections do. If not,
// projections that are apart are those of triangles that are apart.
template <class Orientation>
std::optional<bool> do_projections_intersect(Orientation& orientation,
                                             const Simplex<Orientation, 3>& a,
                                             const Simplex<Orientation, 3>& b)
{
  const auto projection = project_triangle(orientation, a);
  if(!projection)
    return std::nullopt;
  const Sign side_b = projection->projection.orientation(b[0], b[1], b[2]);
  if(side_b == ZERO)
    return std::nullopt;
  return do_triangles_intersect(projection->projection, projection->triangle,
                                counterclockwise<Orientation>(b, side_b));
}

// The sides of the vertices of a triangle along the plane of another one: first what the filter
// knows, then all.
template <class Orientation>
class Sides_of_plane
{
public:
  Sides_of_plane(const Orientation& orientation, const Simplex<Orientation, 3>& of_plane,
                 const Simplex<Orientation, 3>& triangle)
    : plane_(Orientation::plane(of_plane[0], of_plane[1], of_plane[2])), triangle_(triangle)
  {
    for(std::size_t k = 0; k < 3; ++k)
      by_filter_[k] = orientation.side_by_filter(plane_, triangle[k]);
  }

  // Whether the triangle is nearly in the plane, as far as the filter knows.
  bool is_nearly_coplanar() const
  {
    return std::count(by_filter_.begin(), by_filter_.end(), ZERO) > 1;
  }

  std::array<Sign, 3> decide(Orientation& orientation) const
  {
    std::array<Sign, 3> sides;
    for(std::size_t k = 0; k < 3; ++k)
      sides[k] = by_filter_[k] != ZERO ? by_filter_[k]
                                       : orientation.decide_side(plane_, triangle_[k]);
    return sides;
  }

private:
  const typename Orientation::Plane plane_;
  const Simplex<Orientation, 3>& triangle_;
  std::array<Sign, 3> by_filter_;
};

inline bool are_on_one_side(const std::array<Sign, 3>& signs)
{
  return are_all(signs, NEGATIVE) || are_all(signs, POSITIVE);
}

// Which vertex of a triangle is on one side of a plane, closed, with the two others on the other
// side, closed; and whether it is the negative side.
struct Lone_vertex
{
  std::size_t place;
  bool is_below;
};

// The signs are not all zero, and not all on one side.
inline Lone_vertex lone_vertex(const std::array<Sign, 3>& signs)
{
  for(std::size_t k = 0; k < 3; ++k)
    if(signs[k] != ZERO && signs[(k + 1) % 3] != signs[k] && signs[(k + 2) % 3] != signs[k])
      return {k, signs[k] == NEGATIVE};
  std::size_t zero = 0;
  while(signs[zero] != ZERO)
    ++zero;
  return {zero, signs[(zero + 1) % 3] == POSITIVE};
}

// Each triangle p q r and a b c has vertices on both sides of the plane of the other, closed, and
// not all in this plane. So each meets the line of the two planes in an interval. Turn both such
// that p is above the plane of a b c and the others are not, and a above that of p q r. Then the
// intervals go along one direction from p q to p r, and from a c to a b. They meet iff each begins
// before the other ends, and this is a question of orientation (Guigue and Devillers, as above).
template <class Orientation>
bool do_triangles_cross(Orientation& orientation, const Simplex<Orientation, 3>& first,
                        const std::array<Sign, 3>& sides_of_first,
                        const Simplex<Orientation, 3>& second,
                        const std::array<Sign, 3>& sides_of_second)
{
  const Lone_vertex lone_p = lone_vertex(sides_of_first), lone_a = lone_vertex(sides_of_second);
  const auto after = [](const Lone_vertex& lone, std::size_t k) { return (lone.place + k) % 3; };
  const auto& p = first[lone_p.place];
  const auto& q = first[after(lone_p, lone_a.is_below ? 2 : 1)];
  const auto& r = first[after(lone_p, lone_a.is_below ? 1 : 2)];
  const auto& a = second[lone_a.place];
  const auto& b = second[after(lone_a, lone_p.is_below ? 2 : 1)];
  const auto& c = second[after(lone_a, lone_p.is_below ? 1 : 2)];
  return orientation.side(orientation.plane(p, q, a), b) != POSITIVE
         && orientation.side(orientation.plane(p, r, a), c) != NEGATIVE;
}

// Whether points have one coordinate along an axis, as those of a floor or wall have. Then they are
// in one plane, and no determinant has to say so.
template <class Orientation, class... Points>
bool are_level(const typename Orientation::Point& p, const Points&... others)
{
  for(int axis = 2; axis >= 0; --axis)
    if(((Orientation::compare(p, others, axis) == ZERO) && ...))
      return true;
  return false;
}

// The triangles are in one plane, or one of them is degenerate.
template <class Orientation>
bool do_coplanar_or_degenerate_intersect(Orientation& orientation, const Simplex<Orientation, 3>& a,
                                   const Simplex<Orientation, 3>& b)
{
  if(const std::optional<bool> do_projections = do_projections_intersect(orientation, a, b))
    return *do_projections;
  return project_triangle(orientation, a)
           ? do_intersect_in_space(orientation, segment_of_degenerate<Orientation>(b), a)
           : do_intersect_in_space(orientation, segment_of_degenerate<Orientation>(a), b);
}

// If all vertices of one triangle are in the plane of the other one, there is one plane, or a
// triangle is degenerate. Projections come first where the triangles may be in one plane, because
// to tell whether vertices are in a plane costs more.
template <class Orientation>
bool do_intersect_in_space(Orientation& orientation, const Simplex<Orientation, 3>& a,
                           const Simplex<Orientation, 3>& b)
{
  if(are_level<Orientation>(a[0], b[0], a[1], a[2], b[1], b[2]))
    return do_coplanar_or_degenerate_intersect(orientation, a, b);
  const Sides_of_plane<Orientation> of_a(orientation, b, a);
  std::optional<bool> do_projections;
  if(of_a.is_nearly_coplanar()) {
    do_projections = do_projections_intersect(orientation, a, b);
    if(do_projections == false)
      return false;
  }
  const std::array<Sign, 3> sides_a = of_a.decide(orientation);
  if(are_on_one_side(sides_a))
    return false;
  if(do_projections && are_all(sides_a, ZERO))
    return true;
  const Sides_of_plane<Orientation> of_b(orientation, a, b);
  const std::array<Sign, 3> sides_b = of_b.decide(orientation);
  if(are_on_one_side(sides_b))
    return false;
  if(!are_all(sides_a, ZERO) && !are_all(sides_b, ZERO))
    return do_triangles_cross(orientation, a, sides_a, b, sides_b);
  return do_coplanar_or_degenerate_intersect(orientation, a, b);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SPATIAL_OBJECTS_H
