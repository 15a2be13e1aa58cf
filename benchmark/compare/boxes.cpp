// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/box_intersection.h"

namespace thick_benchmark {

void add_boxes(Contestants& all)
{
  for(const std::ptrdiff_t cutoff : {10, 30, 100, 300, 1000}) {
    const std::string name = "box_self_intersection_d, cutoff " + std::to_string(cutoff);
    const auto sequential = on_epick([=](const auto& points, double r, Tally& tally) {
      box_intersection<CGAL::Sequential_tag>(boxes_around(points, r, outwards),
                                             is_near_exactly(points, r), tally, cutoff);
    });
    all.push_back({{name, sequential}, true, cutoff == 300 ? 10000000u : 1000000u});
#ifdef CGAL_LINKED_WITH_TBB
    const auto parallel = on_epick([=](const auto& points, double r, Tally& tally) {
      const Parallel_tally sum;
      box_intersection<CGAL::Parallel_tag>(boxes_around(points, r, outwards),
                                           is_near_exactly(points, r), sum, cutoff);
      tally = sum.sum();
    });
    all.push_back({{name + ", 2 threads", parallel}, true, 1000000, true});
#endif
  }
}

} // namespace thick_benchmark
