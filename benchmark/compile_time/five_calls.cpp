// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Five calls of five kinds in space: near points, lists, the closest pair, boxes, triangles.

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_box_intersection_d.h>
#include <CGAL/thick_intersection_d.h>

#include <cstddef>
#include <vector>

int main()
{
  using Point = CGAL::Epick::Point_3;
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
  const std::vector<Point> points = {a, b, c, d};
  const auto bound = CGAL::within_distance(1);
  int count = 0;
  const auto report = [&](std::size_t, std::size_t) { ++count; };
  CGAL::fixed_radius_near_neighbors(points, bound, report);
  count += static_cast<int>(CGAL::fixed_radius_neighbor_lists(points, bound)[0].size());
  count += static_cast<int>(CGAL::closest_pair(points).second);

  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  const std::vector<Box> boxes = {a.bbox() + b.bbox(), a.bbox() + c.bbox()};
  CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [&](const Box&, const Box&) { ++count; });
  const std::vector<CGAL::Epick::Triangle_3> triangles = {{a, b, c}, {a, b, d}};
  CGAL::thick_self_intersection_d(triangles, report);
  return count == 9 ? 0 : 1;
}
