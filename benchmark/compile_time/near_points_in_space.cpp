// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of fixed_radius_near_neighbors() in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_points.h>

#include <cstddef>
#include <vector>

int main()
{
  const std::vector<CGAL::Epick::Point_3> points = {{0, 0, 0}, {0, 0.05, 0}};
  int count = 0;
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(0.1),
                                    [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}
