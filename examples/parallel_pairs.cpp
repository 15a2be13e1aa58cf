// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// All pairs by several threads. Threads call the callback at the same time, so each of them has a
// vector of its own.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <tbb/enumerable_thread_specific.h>

#include <iostream>
#include <utility>
#include <vector>

int main()
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  CGAL::Random random(1);
  std::vector<Point> points;
  for(int i = 0; i < 100000; ++i)
    points.emplace_back(random.get_double(), random.get_double(), random.get_double());
  const auto bound = CGAL::within_distance(0.02);

  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  tbb::enumerable_thread_specific<Pairs> pairs_of_threads;
  CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(
    points, bound,
    [&](std::size_t i, std::size_t j) { pairs_of_threads.local().emplace_back(i, j); });

  std::size_t count = 0, count_in_sequence = 0;
  for(const Pairs& pairs : pairs_of_threads)
    count += pairs.size();
  CGAL::fixed_radius_near_neighbors(points, bound,
                                    [&](std::size_t, std::size_t) { ++count_in_sequence; });
  std::cout << (count == count_in_sequence ? "the same pairs" : "other pairs") << '\n';
}
