// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// CGAL's box intersection as a broad phase, then the exact distance. The boxes are closed, rounded
// outwards, and carry the position of their point, so no box meets itself and none is lost.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_BOX_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_BOX_ORACLE_H

#include "brute_force.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

namespace test_support {

template <int Dimension>
using Point_box = CGAL::Box_intersection_d::Box_with_info_d<double, Dimension, std::size_t>;

template <int Dimension>
std::vector<Point_box<Dimension>> boxes_around(const Points& points, const Radius& radius)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double half_side = std::nextafter(upper_bound(radius) / 2, infinity);
  std::vector<Point_box<Dimension>> boxes;
  for(std::size_t i = 0; i < points.size(); ++i) {
    double low[Dimension], high[Dimension];
    for(int axis = 0; axis < Dimension; ++axis) {
      low[axis] = std::nextafter(points[i][axis] - half_side, -infinity);
      high[axis] = std::nextafter(points[i][axis] + half_side, infinity);
    }
    boxes.emplace_back(low, high, i);
  }
  return boxes;
}

// One set: pairs (i, j) with i < j.
template <int Dimension>
Pairs box_pairs(const Points& points, const Radius& radius, std::ptrdiff_t cutoff = 10)
{
  const Exact_points exact(points, radius);
  auto boxes = boxes_around<Dimension>(points, radius);
  Pairs pairs;
  const auto report = [&](const auto& a, const auto& b) {
    if(exact.are_within_radius(a.info(), b.info()))
      pairs.emplace_back((std::min)(a.info(), b.info()), (std::max)(a.info(), b.info()));
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), report, cutoff,
                                CGAL::Box_intersection_d::CLOSED);
  return sorted(std::move(pairs));
}

inline Pairs box_pairs(const Point_scene& scene, std::ptrdiff_t cutoff = 10)
{
  switch(scene.dimension) {
  case 2: return box_pairs<2>(scene.points, scene.radius, cutoff);
  case 3: return box_pairs<3>(scene.points, scene.radius, cutoff);
  default: throw std::invalid_argument("the box oracle is for dimensions 2 and 3");
  }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_BOX_ORACLE_H
