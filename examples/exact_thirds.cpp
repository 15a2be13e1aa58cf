// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers that no double holds: a lattice of thirds, and the pairs at a distance of exactly one
// third. A kernel with exact constructions has thirds. Rounded to doubles, some neighbors are
// farther apart than the rounded third; of the doubles, this is the right answer.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <iostream>
#include <vector>

template <class Point, class Number>
std::size_t count_pairs(const std::vector<Point>& points, const Number& distance)
{
  std::size_t count = 0;
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(distance),
                                    [&](std::size_t, std::size_t) { ++count; });
  return count;
}

int main()
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Rounded = CGAL::Exact_predicates_inexact_constructions_kernel;
  const int size = 30;
  std::vector<Exact::Point_2> points;
  std::vector<Rounded::Point_2> rounded;
  for(int x = 0; x < size; ++x)
    for(int y = 0; y < size; ++y) {
      points.emplace_back(Exact::FT(x) / 3, Exact::FT(y) / 3);
      rounded.emplace_back(x / 3., y / 3.);
    }
  const CGAL::Exact_rational third = CGAL::Exact_rational(1) / 3;
  std::cout << 2 * size * (size - 1) << " pairs of neighbors\n"
            << count_pairs(points, third) << " at most a third apart\n"
            << count_pairs(rounded, 1 / 3.) << " after rounding\n";
}
