// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's box_self_intersection_d on the boxes of side r around the points, and then a predicate.
// Boxes are rounded outwards, so that no pair is lost, or computed as programs write it.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_BOX_INTERSECTION_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_BOX_INTERSECTION_H

#include "all_pairs.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace thick_benchmark {

template <int Dimension>
using Numbered_box = CGAL::Box_intersection_d::Box_with_info_d<double, Dimension, std::uint32_t>;

inline double outwards(double x, double infinity) { return std::nextafter(x, infinity); }
inline double as_written(double x, double) { return x; }

// The dimension of the boxes is known to the compiler, that of the points need not be.
template <int Dimension, class Point, class Round>
std::vector<Numbered_box<Dimension>> boxes_around(const std::vector<Point>& points, double r,
                                                  const Round& round)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double half_side = round(r / 2, infinity);
  std::vector<Numbered_box<Dimension>> boxes;
  boxes.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    double low[Dimension], high[Dimension];
    for(int axis = 0; axis < Dimension; ++axis) {
      low[axis] = round(points[i].cartesian(axis) - half_side, -infinity);
      high[axis] = round(points[i].cartesian(axis) + half_side, infinity);
    }
    boxes.emplace_back(low, high, static_cast<std::uint32_t>(i));
  }
  return boxes;
}

template <class Point, class Round>
auto boxes_around(const std::vector<Point>& points, double r, const Round& round)
{
  return boxes_around<dimension_of<Point>>(points, r, round);
}

// Ranges below `cutoff` are scanned; CGAL's default is 10.
template <class ConcurrencyTag, class Box, class Is_near, class Answer>
void box_intersection(
  std::vector<Box> boxes, const Is_near& is_near, Answer& answer, std::ptrdiff_t cutoff = 10,
  CGAL::Box_intersection_d::Topology topology = CGAL::Box_intersection_d::CLOSED)
{
  const auto report = [&](const Box& a, const Box& b) {
    if(is_near(a.info(), b.info()))
      answer(a.info(), b.info());
  };
  CGAL::box_self_intersection_d<ConcurrencyTag>(boxes.begin(), boxes.end(), report, cutoff,
                                                topology);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_BOX_INTERSECTION_H
