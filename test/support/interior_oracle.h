// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether the interiors of polygons on a lattice have a point in common, with each other or with a
// closed feature: by points between all of their edges, in fractions.
//
// Vertical lines through all vertices and crossings cut the plane into slabs. In a slab, edges do
// not cross, so the middles of the gaps between them along one vertical line are in all regions of
// the slab. A closed feature has the middles of its edges between all crossings besides.
//
// This shares nothing with the search. A polygon has the points that are on an odd number of its
// rings' insides.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_INTERIOR_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_INTERIOR_ORACLE_H

#include "feature_oracle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace test_support {

using Fraction = CGAL::Exact_rational;
using Fraction_point = std::array<Fraction, 2>;
using Lattice_segments = std::vector<Lattice_segment>;

// The points of a segment by a parameter, and where it is along an axis.
inline Fraction_point point_at(const Lattice_segment& s, const Fraction& t)
{
  Fraction_point p;
  for(std::size_t axis = 0; axis < 2; ++axis)
    p[axis] = Fraction(s[0][axis] + t * (s[1][axis] - s[0][axis]));
  return p;
}

// The height of a segment that has points left and right of a vertical line, where it meets this.
inline std::optional<Fraction> height_at(const Lattice_segment& s, const Fraction& x)
{
  if((s[0][0] < x) == (s[1][0] < x))
    return std::nullopt;
  return point_at(s, Fraction((x - s[0][0]) / Fraction(s[1][0] - s[0][0])))[1];
}

// Whether a point is on a segment.
inline bool is_on(const Fraction_point& p, const Lattice_segment& s)
{
  const auto d = difference(s[1], s[0]);
  for(std::size_t axis = 0; axis < 2; ++axis)
    if(p[axis] < (std::min)(s[0][axis], s[1][axis]) || p[axis] > (std::max)(s[0][axis], s[1][axis]))
      return false;
  return Fraction(d[0] * (p[1] - s[0][1])) == Fraction(d[1] * (p[0] - s[0][0]));
}

// Whether a point is off the edges of a polygon, and inside.
inline bool is_strictly_inside(const Fraction_point& p, const Lattice_segments& edges)
{
  std::size_t below = 0;
  for(const Lattice_segment& edge : edges) {
    if(is_on(p, edge))
      return false;
    const std::optional<Fraction> y = height_at(edge, p[0]);
    below += y && *y < p[1];
  }
  return below % 2 != 0;
}

// The parameters of a segment where another one ends on it, or crosses it.
inline void add_crossings(const Lattice_segment& s, const Lattice_segment& other,
                          std::vector<Fraction>& parameters)
{
  const auto d = difference(s[1], s[0]), e = difference(other[1], other[0]),
             f = difference(other[0], s[0]);
  const std::int64_t turn = cross(d, e)[2];
  if(turn != 0) {
    const Fraction t(Fraction(cross(f, e)[2]) / Fraction(turn));
    if(t > 0 && t < 1)
      parameters.push_back(t);
    return;
  }
  for(const Lattice_point& end : other)
    for(std::size_t axis = 0; axis < 2; ++axis)
      if(d[axis] != 0) {
        const Fraction t(Fraction(end[axis] - s[0][axis]) / Fraction(d[axis]));
        if(t > 0 && t < 1)
          parameters.push_back(t);
      }
}

// The points of a segment in the middles between all crossings with the line of another segment.
inline std::vector<Fraction_point> middles(const Lattice_segment& s, const Lattice_segments& others)
{
  std::vector<Fraction> parameters = {0, 1};
  for(const Lattice_segment& other : others)
    add_crossings(s, other, parameters);
  std::sort(parameters.begin(), parameters.end());
  std::vector<Fraction_point> points;
  for(std::size_t k = 1; k < parameters.size(); ++k)
    points.push_back(point_at(s, Fraction((parameters[k - 1] + parameters[k]) / 2)));
  return points;
}

// The edges of all rings of each polygon of a feature.
inline std::vector<Lattice_segments> polygons_of(const Lattice_feature& feature)
{
  if(feature.kind != Feature_kind::POLYGONS)
    return {segments_of(feature)};
  std::vector<Lattice_segments> polygons;
  for(const Chain& chain : feature.chains)
    polygons.push_back(segments_of({Feature_kind::POLYGON, {chain}}));
  return polygons;
}

// The middles of the gaps between edges along vertical lines in all slabs.
inline std::vector<Fraction_point> points_of_regions(const Lattice_segments& edges)
{
  std::vector<Fraction> all_x;
  for(const Lattice_segment& s : edges) {
    std::vector<Fraction> parameters = {0, 1};
    for(const Lattice_segment& other : edges)
      add_crossings(s, other, parameters);
    for(const Fraction& t : parameters)
      all_x.push_back(point_at(s, t)[0]);
  }
  std::sort(all_x.begin(), all_x.end());
  all_x.erase(std::unique(all_x.begin(), all_x.end()), all_x.end());
  std::vector<Fraction_point> points;
  for(std::size_t k = 1; k < all_x.size(); ++k) {
    const Fraction x((all_x[k - 1] + all_x[k]) / 2);
    std::vector<Fraction> heights;
    for(const Lattice_segment& s : edges)
      if(const std::optional<Fraction> y = height_at(s, x))
        heights.push_back(*y);
    std::sort(heights.begin(), heights.end());
    for(std::size_t i = 1; i < heights.size(); ++i)
      if(heights[i - 1] != heights[i])
        points.push_back({x, Fraction((heights[i - 1] + heights[i]) / 2)});
  }
  return points;
}

inline bool do_polygons_overlap(const Lattice_segments& a, const Lattice_segments& b)
{
  Lattice_segments both = a;
  both.insert(both.end(), b.begin(), b.end());
  const std::vector<Fraction_point> points = points_of_regions(both);
  return std::any_of(points.begin(), points.end(), [&](const Fraction_point& p) {
    return is_strictly_inside(p, a) && is_strictly_inside(p, b);
  });
}

// Whether a point of a segment is in the interior of a polygon.
inline bool does_enter(const Lattice_segment& s, const Lattice_segments& polygon)
{
  const auto is_in = [&](const Fraction_point& p) { return is_strictly_inside(p, polygon); };
  const std::vector<Fraction_point> points = middles(s, polygon);
  return is_in(point_at(s, 0)) || is_in(point_at(s, 1))
         || std::any_of(points.begin(), points.end(), is_in);
}

// Whether the interior of `a` meets `b`, or the interior of `b`.
inline bool do_interiors_meet(const Lattice_feature& a, const Lattice_feature& b, bool is_b_open)
{
  for(const Lattice_segments& polygon : polygons_of(a))
    for(const Lattice_segments& other : polygons_of(b))
      if((b.is_filled() && do_polygons_overlap(polygon, other))
         || (!is_b_open && std::any_of(other.begin(), other.end(), [&](const Lattice_segment& s) {
               return does_enter(s, polygon);
             })))
        return true;
  return false;
}

// The least and the largest coordinates along an axis.
inline std::array<std::int64_t, 2> extent_of(const Lattice_feature& feature, std::size_t axis)
{
  std::array<std::int64_t, 2> extent = {std::int64_t(1) << 40, -(std::int64_t(1) << 40)};
  for(const Chain& chain : feature.chains)
    for(const Lattice_point& p : chain)
      extent = {(std::min)(extent[0], p[axis]), (std::max)(extent[1], p[axis])};
  return extent;
}

// Pairs of two sets, whose polygons are open or closed. One set at least is open.
inline Pairs pairs_of_interiors(const Lattice_features& first, bool is_first_open,
                                const Lattice_features& second, bool is_second_open)
{
  Pairs pairs;
  for(std::size_t i = 0; i < first.size(); ++i)
    for(std::size_t j = 0; j < second.size(); ++j) {
      bool do_boxes_meet = true;
      for(std::size_t axis = 0; axis < 2; ++axis) {
        const auto a = extent_of(first[i], axis), b = extent_of(second[j], axis);
        do_boxes_meet &= a[0] <= b[1] && b[0] <= a[1];
      }
      if(do_boxes_meet
         && (is_first_open ? do_interiors_meet(first[i], second[j], is_second_open)
                           : do_interiors_meet(second[j], first[i], false)))
        pairs.emplace_back(i, j);
    }
  return pairs;
}

// The pairs i < j of one set.
inline Pairs pairs_of_interiors(const Lattice_features& features)
{
  Pairs pairs;
  for(const Pair& pair : pairs_of_interiors(features, true, features, true))
    if(pair.first < pair.second)
      pairs.push_back(pair);
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_INTERIOR_ORACLE_H
