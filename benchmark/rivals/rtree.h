// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boost.Geometry's R-tree, packed when it is made, asked for the box around each point; then the
// exact predicate. The boxes are rounded outwards.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_RTREE_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_RTREE_H

#include "near_points.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace thick_benchmark {

template <int Dimension>
using Rtree_point = boost::geometry::model::point<double, Dimension,
                                                  boost::geometry::cs::cartesian>;

// A corner of the box around p, rounded outwards.
template <class Point>
Rtree_point<dimension_of<Point>> corner(const Point& p, double offset)
{
  const double outwards = std::copysign(std::numeric_limits<double>::infinity(), offset);
  const auto x = [&](int axis) {
    return offset == 0 ? p.cartesian(axis)
                       : std::nextafter(p.cartesian(axis) + offset, outwards);
  };
  if constexpr(dimension_of<Point> == 2)
    return {x(0), x(1)};
  else
    return {x(0), x(1), x(2)};
}

template <class Point, class Callback>
void rtree_search(const std::vector<Point>& points, double r, Callback& callback)
{
  namespace index = boost::geometry::index;
  using Corner = Rtree_point<dimension_of<Point>>;
  using Numbered_point = std::pair<Corner, std::uint32_t>;

  std::vector<Numbered_point> numbered;
  for(std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(corner(points[i], 0), static_cast<std::uint32_t>(i));
  const index::rtree<Numbered_point, index::linear<16>> tree(numbered);

  const Is_near<Point> is_near = make_is_near<Point>(r);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto report = [&](const Numbered_point& p) {
      if(i < p.second && is_near(points[i], points[p.second]))
        callback(i, p.second);
    };
    const boost::geometry::model::box<Corner> box(corner(points[i], -r), corner(points[i], r));
    tree.query(index::intersects(box), boost::make_function_output_iterator(report));
  }
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_RTREE_H
