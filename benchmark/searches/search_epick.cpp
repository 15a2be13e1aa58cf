// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

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

template <int Dimension>
Run naive_double_loop_d(const Scene& scene)
{
  using Points = std::vector<Point_t<Kernel, Dimension>>;
  const auto points = std::make_shared<const Points>(make_points<Kernel, Dimension>(scene));
  return [points, r = scene.r] {
    const Points& p = *points;
    Tally tally;
    for(std::size_t i = 0; i < p.size(); ++i)
      for(std::size_t j = i + 1; j < p.size(); ++j)
        if(CGAL::squared_distance(p[i], p[j]) <= r * r)
          tally(i, j);
    return tally;
  };
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

Run naive_double_loop(const Scene& scene)
{
  return scene.dimension == 2 ? naive_double_loop_d<2>(scene) : naive_double_loop_d<3>(scene);
}

} // namespace thick_benchmark
