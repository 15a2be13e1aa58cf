// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "all_pairs.h"
#include "kernel_search.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace thick_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Search search_epick(const Scene& scene)
{
  return kernel_search<Kernel>(scene);
}

std::uint64_t count_pairs(const Scene& scene, std::uint64_t limit)
{
  const auto search = [limit](const auto& points, double r, std::uint64_t& count) {
    count = 0;
    const auto count_up = [&](std::size_t, std::size_t) { return ++count <= limit; };
    CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(r), count_up);
  };
  return on_points<std::uint64_t, Kernel>(search)(scene)();
}

Run<Tally> naive_double_loop(const Scene& scene)
{
  const auto search = [](const auto& points, double r, Tally& tally) {
    const auto is_near = [&](std::size_t i, std::size_t j) {
      return CGAL::squared_distance(points[i], points[j]) <= r * r;
    };
    all_pairs(points.size(), is_near, tally);
  };
  return on_points<Tally, Kernel>(search)(scene);
}

} // namespace thick_benchmark
