// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's box_self_intersection_d on the boxes of side r around the points, and then the exact
// predicate. The boxes are closed and rounded outwards, so that none is lost.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_BOX_INTERSECTION_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_BOX_INTERSECTION_H

#include "near_points.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace thick_benchmark {

template <class Point>
using Box_of_point
  = CGAL::Box_intersection_d::Box_with_info_d<double, dimension_of<Point>, std::uint32_t>;

template <class Point>
std::vector<Box_of_point<Point>> boxes_around(const std::vector<Point>& points, double r)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double half_side = std::nextafter(r / 2, infinity);
  std::vector<Box_of_point<Point>> boxes;
  boxes.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    double low[dimension_of<Point>], high[dimension_of<Point>];
    for(int axis = 0; axis < dimension_of<Point>; ++axis) {
      low[axis] = std::nextafter(points[i].cartesian(axis) - half_side, -infinity);
      high[axis] = std::nextafter(points[i].cartesian(axis) + half_side, infinity);
    }
    boxes.emplace_back(low, high, static_cast<std::uint32_t>(i));
  }
  return boxes;
}

// Ranges below `cutoff` are scanned; CGAL's default is 10.
template <class ConcurrencyTag, class Point, class Callback>
void box_intersection(const std::vector<Point>& points, double r, std::ptrdiff_t cutoff,
                      Callback& callback)
{
  const Is_near<Point> is_near = make_is_near<Point>(r);
  std::vector<Box_of_point<Point>> boxes = boxes_around(points, r);
  const auto report = [&](const Box_of_point<Point>& a, const Box_of_point<Point>& b) {
    if(is_near(points[a.info()], points[b.info()]))
      callback(a.info(), b.info());
  };
  CGAL::box_self_intersection_d<ConcurrencyTag>(boxes.begin(), boxes.end(), report, cutoff,
                                                CGAL::Box_intersection_d::CLOSED);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_BOX_INTERSECTION_H
