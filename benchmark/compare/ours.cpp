// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/all_pairs.h"
#include "methods/ours.h"

namespace thick_benchmark {

void add_ours(Contestants& all)
{
  const std::size_t any = 100000000;
  const auto epick = [](const Scene& scene) { return search_epick(scene).sequential; };
  all.push_back({{"Thick_intersection_d", epick}, true, any});
#ifdef CGAL_LINKED_WITH_TBB
  const auto parallel = [](const Scene& scene) { return search_epick(scene).parallel; };
  all.push_back({{"Thick_intersection_d, 2 threads", parallel}, true, any});
#endif
  all.push_back({{"std::sort of x", sort_of_x<Tally>}, false, any});
  const auto by_all_pairs = on_epick([](const auto& points, double r, Tally& tally) {
    all_pairs(points.size(), is_near_exactly(points, r), tally);
  });
  all.push_back({{"all pairs", by_all_pairs}, true, 10000});
}

} // namespace thick_benchmark
