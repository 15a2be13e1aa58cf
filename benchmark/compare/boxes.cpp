// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/box_intersection.h"

namespace thick_benchmark {

void add_boxes(Contestants& all)
{
  for(const std::ptrdiff_t cutoff : {10, 30, 100, 300, 1000}) {
    const auto boxes = on_epick([=](const auto& points, double r, Tally& tally) {
      box_intersection<CGAL::Sequential_tag>(boxes_around(points, r, outwards),
                                             is_near_exactly(points, r), tally, cutoff);
    });
    all.push_back({{"box_self_intersection_d, cutoff " + std::to_string(cutoff), boxes}, true,
                   cutoff == 300 ? 10000000u : 1000000u});
  }
}

} // namespace thick_benchmark
