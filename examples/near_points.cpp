// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// All pairs of points within a distance.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <iostream>
#include <vector>

int main()
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const std::vector<Kernel::Point_2> points = {{0, 0}, {3, 4}, {3, 4.5}, {10, 10}};
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(5),
                                    [](std::size_t i, std::size_t j)
                                    { std::cout << i << ' ' << j << '\n'; });
}
