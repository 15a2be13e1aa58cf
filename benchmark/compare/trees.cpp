// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"
#include "methods/kd_tree.h"
#include "methods/nanoflann.h"

namespace thick_benchmark {

void add_trees(Contestants& all)
{
  const auto kd_tree = on_epick([](const auto& points, double r, Tally& tally) {
    kd_tree_search<Epick>(points, r, tally);
  });
  all.push_back({{"Kd_tree + Fuzzy_sphere", kd_tree}, false, 1000000});
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
  const auto nanoflann = on_epick([](const auto& points, double r, Tally& tally) {
    nanoflann_search(points, nanoflann_closed(r), tally);
  });
  all.push_back({{"nanoflann", nanoflann}, false, 10000000});
#endif
}

} // namespace thick_benchmark
