// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// nanoflann's kd-tree of static dimension, asked for the ball around each point. Its squared
// distances are doubles, compared with the rounded square of r, and by "less": it is not exact.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_NANOFLANN_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_NANOFLANN_H

#include "near_points.h"

#include <nanoflann.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace thick_benchmark {

// What nanoflann asks of a container of points.
template <class Point>
struct Nanoflann_points
{
  const std::vector<Point>& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return points[i].cartesian(static_cast<int>(axis));
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};

// Hands on what nanoflann finds, without storing it.
template <class Callback>
class Nanoflann_results
{
public:
  Nanoflann_results(std::size_t i, double squared_distance, Callback& callback)
    : i_(i), squared_distance_(squared_distance), callback_(callback)
  {}

  std::size_t size() const { return 0; }
  bool full() const { return true; }
  double worstDist() const { return squared_distance_; }
  bool addPoint(double squared_distance, std::uint32_t j)
  {
    if(i_ < j && squared_distance < squared_distance_)
      callback_(i_, j);
    return true;
  }

private:
  const std::size_t i_;
  const double squared_distance_;
  Callback& callback_;
};

template <class Point, class Callback>
void nanoflann_search(const std::vector<Point>& points, double r, Callback& callback)
{
  using Points = Nanoflann_points<Point>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                   Points, dimension_of<Point>, std::uint32_t>;
  const Points adapted{points};
  const Tree tree(dimension_of<Point>, adapted);
  // The next double makes "less" mean "at most".
  const double squared = std::nextafter(r * r, std::numeric_limits<double>::infinity());
  for(std::size_t i = 0; i < points.size(); ++i) {
    double center[dimension_of<Point>];
    for(int axis = 0; axis < dimension_of<Point>; ++axis)
      center[axis] = points[i].cartesian(axis);
    Nanoflann_results<Callback> results(i, squared, callback);
    tree.radiusSearchCustomCallback(center, results);
  }
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_NANOFLANN_H
