// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lists of neighbors in a solver of one's own: a field on scattered points is smoothed until it
// hardly changes. The lists are compressed rows, as those of sparse matrices, made once.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

// Sets each inner value to the mean of those of the neighbors. Returns the largest change.
double smooth(const std::vector<Point>& points, const CGAL::Neighbor_lists& neighbors,
              std::vector<double>& values)
{
  double change = 0;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const bool is_inner = 0.1 < points[i].x() && points[i].x() < 0.9;
    if(!is_inner || neighbors[i].empty())
      continue;
    double sum = 0;
    for(const std::size_t j : neighbors[i])
      sum += values[j];
    const double mean = sum / static_cast<double>(neighbors[i].size());
    change = (std::max)(change, std::fabs(mean - values[i]));
    values[i] = mean;
  }
  return change;
}

int main()
{
  CGAL::Random random(1);
  std::vector<Point> points;
  for(int i = 0; i < 2000; ++i) {
    const double x = random.get_double(); // first, as compilers choose the order of arguments
    points.emplace_back(x, random.get_double());
  }
  const CGAL::Neighbor_lists neighbors
    = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(0.06));

  std::vector<double> values; // 0 on the left, 1 on the right
  for(const Point& p : points)
    values.push_back(p.x() < 0.5 ? 0 : 1);
  int rounds = 1;
  while(smooth(points, neighbors, values) > 1e-6)
    ++rounds;

  double in_the_middle = 0, count = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(std::fabs(points[i].x() - 0.5) < 0.05) {
      in_the_middle += values[i];
      ++count;
    }
  std::cout << "smooth after " << rounds << " rounds: " << in_the_middle / count
            << " in the middle\n";
}
