// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/box_intersection.h"
#include "methods/kd_tree.h"
#include "methods/nanoflann.h"
#include "methods/rtree.h"
#ifdef THICK_BENCHMARK_HAS_ANN
#include "methods/ann.h"
#endif

namespace thick_benchmark {

void add_trees(Contestants& all)
{
  const auto kd_tree = on_epick([](const auto& points, double r, Tally& tally) {
    kd_tree_search<Epick>(points, r, tally);
  });
  all.push_back({{"Kd_tree + Fuzzy_sphere", kd_tree}, false, 1000000});
  const auto rtree = on_epick([](const auto& points, double r, Tally& tally) {
    const auto is_near = is_near_exactly(points, r);
    rtree_search(points, r, outwards, [&](const auto& a, const auto& b) {
      if(a.second < b.second && is_near(a.second, b.second))
        tally(a.second, b.second);
    });
  });
  all.push_back({{"Boost.Geometry rtree", rtree}, true, 1000000});
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
  const auto nanoflann = on_epick([](const auto& points, double r, Tally& tally) {
    nanoflann_search(points, nanoflann_closed(r), tally);
  });
  all.push_back({{"nanoflann", nanoflann}, false, 10000000});
#endif
#ifdef THICK_BENCHMARK_HAS_ANN
  const auto ann = on_epick([](const auto& points, double r, Tally& tally) {
    ann_search(points, r, tally);
  });
  all.push_back({{"ANN", ann}, false, 1000000, true});
#endif
}

} // namespace thick_benchmark
