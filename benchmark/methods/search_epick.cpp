// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "all_pairs.h"
#include "kernel_search.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace thick_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <int Dimension>
std::uint64_t count_pairs_d(const Scene& scene, std::uint64_t limit)
{
  std::uint64_t count = 0;
  const auto count_up = [&](std::size_t, std::size_t) { return ++count <= limit; };
  CGAL::fixed_radius_near_neighbors(make_points<Kernel, Dimension>(scene),
                                    CGAL::within_distance(scene.r), count_up);
  return count;
}

} // namespace

Search search_epick(const Scene& scene)
{
  return kernel_search<Kernel>(scene);
}

std::uint64_t count_pairs(const Scene& scene, std::uint64_t limit)
{
  return scene.dimension == 2 ? count_pairs_d<2>(scene, limit) : count_pairs_d<3>(scene, limit);
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
