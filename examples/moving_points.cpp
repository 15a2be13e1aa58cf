// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that move away from their neighbors, step by step. The lists of each step take the memory
// of those of the step before.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

int main()
{
  CGAL::Random random(1);
  std::vector<Point> points;
  for(int i = 0; i < 2000; ++i)
    points.emplace_back(random.get_double(), random.get_double());

  const auto bound = CGAL::within_distance(0.02);
  CGAL::Neighbor_lists neighbors;
  for(int step = 0; step < 20; ++step) {
    CGAL::fixed_radius_neighbor_lists(points, bound, neighbors);
    if(step == 0)
      std::cout << neighbors.number_of_pairs() << " pairs are near before";
    std::vector<Point> moved;
    for(std::size_t i = 0; i < points.size(); ++i) {
      Kernel::Vector_2 way(0, 0);
      for(const std::size_t j : neighbors[i])
        way = way + (points[i] - points[j]);
      moved.push_back(points[i] + 0.1 * way);
    }
    points = moved;
  }
  CGAL::fixed_radius_neighbor_lists(points, bound, neighbors);
  std::cout << ", " << neighbors.number_of_pairs() << " after\n";
}
