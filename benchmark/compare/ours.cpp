// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/all_pairs.h"
#include "../support/Search.h"
#include "methods.h"

#include <algorithm>

namespace thick_benchmark {

namespace {

Run sort_of_x(const Scene& scene)
{
  std::vector<double> unsorted;
  for(std::size_t i = 0; i < scene.coordinates.size();
      i += static_cast<std::size_t>(scene.dimension))
    unsorted.push_back(scene.coordinates[i]);
  return [unsorted] {
    std::vector<double> x = unsorted;
    std::sort(x.begin(), x.end());
    return Tally();
  };
}

template <class Kernel_search>
std::function<Run(const Scene&)> sequential(const Kernel_search& search)
{
  return [search](const Scene& scene) { return search(scene).sequential; };
}

} // namespace

void add_ours(Methods& methods)
{
  const std::size_t any = 100000000;
  methods.push_back({"Thick_intersection_d", Answer::EXACT, any, false, sequential(search_epick)});
#ifdef CGAL_LINKED_WITH_TBB
  methods.push_back({"Thick_intersection_d, 2 threads", Answer::EXACT, any, false,
                     [](const Scene& scene) { return search_epick(scene).parallel; }});
#endif
  methods.push_back({"Thick_intersection_d, EPECK", Answer::EXACT, 1000000, true,
                     sequential(search_epeck)});
  methods.push_back({"std::sort of x", Answer::NONE, any, false, sort_of_x});
  methods.push_back({"all pairs", Answer::EXACT, 10000, false,
                     on_points([](const auto& points, double r, Tally& tally) {
                       all_pairs(points, r, tally);
                     })});
}

} // namespace thick_benchmark
