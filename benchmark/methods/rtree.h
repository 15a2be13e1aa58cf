// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boost.Geometry's R-tree, packed when it is made, asked for a window around each point.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_RTREE_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_RTREE_H

#include "all_pairs.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace thick_benchmark {

// A corner of the window around p. round(x, infinity) rounds it; see box_intersection.h.
template <class Point, class Round>
auto rtree_corner(const Point& p, double offset, const Round& round)
{
  using Corner
    = boost::geometry::model::point<double, dimension_of<Point>, boost::geometry::cs::cartesian>;
  const double infinity = std::copysign(std::numeric_limits<double>::infinity(), offset);
  const auto x = [&](int axis) {
    return offset == 0 ? p.cartesian(axis) : round(p.cartesian(axis) + offset, infinity);
  };
  if constexpr(dimension_of<Point> == 2)
    return Corner(x(0), x(1));
  else
    return Corner(x(0), x(1), x(2));
}

// Calls report(a, b) for each point a and all points b in its window, both of them pairs of a
// point of Boost's and a position.
template <class Point, class Round, class Report>
void rtree_search(const std::vector<Point>& points, double r, const Round& round,
                  const Report& report)
{
  using Corner = decltype(rtree_corner(points[0], 0., round));
  using Numbered_point = std::pair<Corner, std::uint32_t>;
  namespace index = boost::geometry::index;

  std::vector<Numbered_point> numbered;
  for(std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(rtree_corner(points[i], 0, round), static_cast<std::uint32_t>(i));
  const index::rtree<Numbered_point, index::linear<16>> tree(numbered);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const boost::geometry::model::box<Corner> window(rtree_corner(points[i], -r, round),
                                                     rtree_corner(points[i], r, round));
    tree.query(index::intersects(window), boost::make_function_output_iterator(
                                            [&](const auto& p) { report(numbered[i], p); }));
  }
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_RTREE_H
