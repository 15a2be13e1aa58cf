// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The default search on the points of a kernel.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_KERNEL_SEARCH_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_KERNEL_SEARCH_H

#include "ours.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <memory>

namespace thick_benchmark {

template <class Point>
double sum_of_intervals(const std::vector<Point>& points)
{
  double sum = 0;
  for(const Point& p : points)
    for(int axis = 0; axis < p.dimension(); ++axis) {
      const std::pair<double, double> interval = CGAL::to_interval(p.cartesian(axis));
      sum += interval.first + interval.second;
    }
  return sum;
}

template <class Kernel, int Dimension>
Search kernel_search(const Scene& scene)
{
  using Points = std::vector<Point_t<Kernel, Dimension>>;
  const auto points = std::make_shared<const Points>(make_points<Kernel, Dimension>(scene));
  const auto bound = CGAL::within_distance(scene.r);
  Search search;
  search.sequential = [points, bound] {
    Tally tally;
    CGAL::fixed_radius_near_neighbors(*points, bound, tally);
    return tally;
  };
#ifdef CGAL_LINKED_WITH_TBB
  search.parallel = [points, bound] {
    const Parallel_tally tally;
    CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(*points, bound, tally);
    return tally.sum();
  };
  search.sequential_like_parallel = [points, bound] {
    const Parallel_tally tally;
    CGAL::fixed_radius_near_neighbors(*points, bound, tally);
    return tally.sum();
  };
#endif
  search.lists = [points, bound] {
    return CGAL::fixed_radius_neighbor_lists(*points, bound).number_of_pairs();
  };
  search.sum_of_intervals = [points] { return sum_of_intervals(*points); };
  return search;
}

template <class Kernel>
Search kernel_search(const Scene& scene)
{
  return scene.dimension == 2 ? kernel_search<Kernel, 2>(scene) : kernel_search<Kernel, 3>(scene);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_KERNEL_SEARCH_H
