// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// nanoflann's kd-tree of static dimension, without storing results. Its squared distances are
// doubles, compared with a rounded square by "less": it is not exact. Where nanoflann is missing,
// THICK_BENCHMARK_HAS_NANOFLANN is not defined.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_NANOFLANN_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_NANOFLANN_H

#if __has_include(<nanoflann.hpp>)
#define THICK_BENCHMARK_HAS_NANOFLANN

#include "all_pairs.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <array>
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

  std::array<double, dimension_of<Point>> center(std::size_t i) const
  {
    std::array<double, dimension_of<Point>> center;
    for(std::size_t axis = 0; axis < center.size(); ++axis)
      center[axis] = kdtree_get_pt(i, axis);
    return center;
  }
};

template <class Point>
using Nanoflann_tree = nanoflann::KDTreeSingleIndexAdaptor<
  nanoflann::L2_Simple_Adaptor<double, Nanoflann_points<Point>>, Nanoflann_points<Point>,
  dimension_of<Point>, std::uint32_t>;

// Hands on what nanoflann finds.
template <class Answer>
class Nanoflann_results
{
public:
  Nanoflann_results(std::size_t i, double square, Answer& answer)
    : i_(i), square_(square), answer_(answer)
  {}

  std::size_t size() const { return 0; }
  bool full() const { return true; }
  double worstDist() const { return square_; }
  bool addPoint(double squared_distance, std::uint32_t j)
  {
    if(squared_distance < square_)
      answer_.neighbour(i_, j);
    return true;
  }

private:
  const std::size_t i_;
  const double square_;
  Answer& answer_;
};

// The square for a closed ball: the next double makes "less" mean "at most".
inline double nanoflann_closed(double r)
{
  return std::nextafter(r * r, std::numeric_limits<double>::infinity());
}

// The ball around each point. It is open.
template <class Point, class Answer>
void nanoflann_search(const std::vector<Point>& points, double square, Answer& answer)
{
  const Nanoflann_points<Point> adapted{points};
  const Nanoflann_tree<Point> tree(dimension_of<Point>, adapted);
  for(std::size_t i = 0; i < points.size(); ++i) {
    Nanoflann_results<Answer> results(i, square, answer);
    tree.radiusSearchCustomCallback(adapted.center(i).data(), results);
  }
}

} // namespace thick_benchmark

#endif // __has_include(<nanoflann.hpp>)

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_NANOFLANN_H
