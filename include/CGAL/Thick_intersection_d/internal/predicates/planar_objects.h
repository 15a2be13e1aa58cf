// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_PLANAR_OBJECTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_PLANAR_OBJECTS_H

// Do closed segments and triangles in the plane intersect? Or those in a plane of space, by their
// projections along an axis.
//
// `Orientation` decides about points, as Staged_orientation does.

#include <CGAL/enum.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The vertices of a segment, triangle or tetrahedron, or a point.
template <class Orientation, std::size_t Count>
using Simplex = std::array<typename Orientation::Point, Count>;

// An orientation of points that sees two axes of them.
template <class Orientation>
class Projection
{
public:
  using Point = typename Orientation::Point;

  Projection(Orientation& orientation, int i, int j) : orientation_(orientation), i_(i), j_(j) {}

  BOOST_FORCEINLINE Sign orientation(const Point& p, const Point& q, const Point& r) const
  {
    if constexpr(Orientation::dimension == 2)
      return orientation_.orientation(p, q, r, 0, 1);
    else
      return orientation_.orientation(p, q, r, i_, j_);
  }

  // The same in two parts: what the filter knows, or zero, and what to ask then.
  Sign orientation_by_filter(const Point& p, const Point& q, const Point& r) const
  {
    if constexpr(Orientation::dimension == 2)
      return orientation_.orientation_by_filter(p, q, r, 0, 1);
    else
      return orientation_.orientation_by_filter(p, q, r, i_, j_);
  }

  Sign decide_orientation(const Point& p, const Point& q, const Point& r) const
  {
    return orientation_.decide_orientation(p, q, r, i_, j_);
  }

  // Whether the boxes of the segments p q and r s meet.
  bool do_boxes_meet(const Point& p, const Point& q, const Point& r, const Point& s) const
  {
    return do_intervals_meet(p, q, r, s, i_) && do_intervals_meet(p, q, r, s, j_);
  }

private:
  bool do_intervals_meet(const Point& p, const Point& q, const Point& r, const Point& s,
                         int axis) const
  {
    const auto is_above = [&](const Point& x, const Point& y, const Point& z) {
      return orientation_.compare(x, y, axis) == POSITIVE
             && orientation_.compare(x, z, axis) == POSITIVE;
    };
    return !(is_above(p, r, s) && is_above(q, r, s)) && !(is_above(r, p, q) && is_above(s, p, q));
  }

  Orientation& orientation_;
  int i_;
  int j_;
};

// Segments may be points. They intersect if each has no side of the line of the other to itself.
// Only if all four points are on a line, their boxes have to meet besides. If one segment is a
// point, all turns with it are zero, and the other turns tell whether it is on the line of the
// other segment.
template <class Orientation>
bool do_segments_intersect(const Projection<Orientation>& projection,
                           const Simplex<Orientation, 2>& a, const Simplex<Orientation, 2>& b)
{
  const Sign b0 = projection.orientation(a[0], a[1], b[0]);
  const Sign b1 = projection.orientation(a[0], a[1], b[1]);
  if(b0 == b1 && b0 != ZERO)
    return false;
  const Sign a0 = projection.orientation(b[0], b[1], a[0]);
  const Sign a1 = projection.orientation(b[0], b[1], a[1]);
  if(a0 == a1 && a0 != ZERO)
    return false;
  const bool are_on_line = a0 == ZERO && a1 == ZERO && b0 == ZERO && b1 == ZERO;
  return !are_on_line || projection.do_boxes_meet(a[0], a[1], b[0], b[1]);
}

// The sides of a point along the edges of a triangle. That of edge k is the turn from vertex k to
// vertex k + 1 to the point. The filter comes first for all of them, so that compilers subtract the
// point from a vertex once.
template <class Orientation>
std::array<Sign, 3> sides_of_edges(const Projection<Orientation>& projection,
                                   const Simplex<Orientation, 3>& triangle,
                                   const typename Orientation::Point& p)
{
  std::array<Sign, 3> sides;
  for(std::size_t k = 0; k < 3; ++k)
    sides[k] = projection.orientation_by_filter(p, triangle[k], triangle[(k + 1) % 3]);
  for(std::size_t k = 0; k < 3; ++k)
    if(sides[k] == ZERO)
      sides[k] = projection.decide_orientation(p, triangle[k], triangle[(k + 1) % 3]);
  return sides;
}

inline bool is_any_negative(const std::array<Sign, 3>& signs)
{
  return signs[0] == NEGATIVE || signs[1] == NEGATIVE || signs[2] == NEGATIVE;
}

// The triangle turns left. If the segment begins outside, it enters through an edge that it begins
// beyond.
template <class Orientation>
bool does_segment_meet_triangle(const Projection<Orientation>& projection,
                                const Simplex<Orientation, 2>& segment,
                                const Simplex<Orientation, 3>& triangle)
{
  const std::array<Sign, 3> sides = sides_of_edges(projection, triangle, segment[0]);
  if(!is_any_negative(sides))
    return true;
  for(std::size_t k = 0; k < 3; ++k)
    if(sides[k] == NEGATIVE
       && do_segments_intersect(projection, segment, {triangle[k], triangle[(k + 1) % 3]}))
      return true;
  return false;
}

// The triangle p q r turns left, or is degenerate. The turn from c to a to p is negative, so p sees
// the segment from c to a turn left from a to c. Returns whether the triangle meets this segment,
// or nothing if the line of the segment has all of the triangle on one side, strictly.
//
// Otherwise the triangle and the line have an interval in common, or a point if the triangle is
// degenerate. Along the line from a to c, it begins on the edge of the triangle that ends beyond
// the line and turns right as seen from p.
template <class Orientation>
std::optional<bool> does_triangle_reach(const Projection<Orientation>& projection,
                                        const Simplex<Orientation, 3>& triangle,
                                        const typename Orientation::Point& c,
                                        const typename Orientation::Point& a)
{
  const auto& [p, q, r] = triangle;
  const auto is_left = [&](const auto& x, const auto& y, const auto& z) {
    return projection.orientation(x, y, z) != NEGATIVE;
  };
  if(is_left(c, a, q)) // the interval begins on p q: behind a, or else it has to hold a
    return is_left(p, a, q) ? is_left(p, q, c) : is_left(q, r, a) && is_left(r, p, a);
  if(!is_left(c, a, r))
    return std::nullopt;
  // The interval begins on q r and ends on p r. It has to end behind a, and to begin before c.
  return is_left(p, a, r) && is_left(q, r, c);
}

// Both triangles turn left; the first one may be degenerate. If its vertex p is outside of the
// other one, what p sees of the other is edges that p is beyond, and each segment from p to it
// crosses one of them. This is the idea of P. Guigue and O. Devillers (Journal of Graphics Tools 8,
// 2003).
template <class Orientation>
bool do_triangles_intersect(const Projection<Orientation>& projection,
                            const Simplex<Orientation, 3>& a, const Simplex<Orientation, 3>& b)
{
  const std::array<Sign, 3> sides = sides_of_edges(projection, b, a[0]);
  if(!is_any_negative(sides))
    return true;
  for(std::size_t k = 0; k < 3; ++k)
    if(sides[k] == NEGATIVE) {
      const std::optional<bool> does_reach
        = does_triangle_reach(projection, a, b[k], b[(k + 1) % 3]);
      if(!does_reach || *does_reach)
        return does_reach.has_value();
    }
  return false;
}

// Returns the triangle with its vertices in the order in which they turn left, if it turns to
// `side`. Which side it is cannot be predicted, so it takes no branch.
template <class Orientation>
Simplex<Orientation, 3> counterclockwise(const Simplex<Orientation, 3>& triangle, Sign side)
{
  const std::size_t second = side == NEGATIVE ? 2 : 1;
  return {triangle[0], triangle[second], triangle[3 - second]};
}

// Returns the segment from the first to the last of some points on a line, by their coordinates.
template <class Orientation, std::size_t Count>
Simplex<Orientation, 2> segment_of_degenerate(const Simplex<Orientation, Count>& points)
{
  using Point = typename Orientation::Point;
  const auto is_before = [](const Point& p, const Point& q) {
    for(int axis = 0; axis < Orientation::dimension; ++axis)
      if(const Sign sign = Orientation::compare(p, q, axis); sign != ZERO)
        return sign == NEGATIVE;
    return false;
  };
  const auto ends = std::minmax_element(points.begin(), points.end(), is_before);
  return {*ends.first, *ends.second};
}

// ---- objects of the plane -----------------------------------------------------------------------

template <class Orientation>
Projection<Orientation> plane_itself(Orientation& orientation)
{
  return {orientation, 0, 1};
}

// The triangles may be degenerate, as all objects below.
template <class Orientation>
bool do_intersect_in_plane(Orientation& orientation, const Simplex<Orientation, 2>& a,
                           const Simplex<Orientation, 2>& b)
{
  return do_segments_intersect(plane_itself(orientation), a, b);
}

template <class Orientation>
bool do_intersect_in_plane(Orientation& orientation, const Simplex<Orientation, 2>& segment,
                           const Simplex<Orientation, 3>& triangle)
{
  const Projection<Orientation> projection = plane_itself(orientation);
  const Sign side = projection.orientation(triangle[0], triangle[1], triangle[2]);
  if(side == ZERO)
    return do_segments_intersect(projection, segment, segment_of_degenerate<Orientation>(triangle));
  return does_segment_meet_triangle(projection, segment,
                                    counterclockwise<Orientation>(triangle, side));
}

template <class Orientation>
bool do_intersect_in_plane(Orientation& orientation, const Simplex<Orientation, 3>& a,
                           const Simplex<Orientation, 3>& b)
{
  const Projection<Orientation> projection = plane_itself(orientation);
  const Sign side_a = projection.orientation(a[0], a[1], a[2]);
  const Sign side_b = projection.orientation(b[0], b[1], b[2]);
  if(side_b == ZERO)
    return do_intersect_in_plane(orientation, segment_of_degenerate<Orientation>(b), a);
  return do_triangles_intersect(projection, counterclockwise<Orientation>(a, side_a),
                                counterclockwise<Orientation>(b, side_b));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_PLANAR_OBJECTS_H
