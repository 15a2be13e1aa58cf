// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/box_intersection.h"
#include "methods.h"

namespace thick_benchmark {

void add_box_intersection(Methods& methods)
{
  for(const std::ptrdiff_t cutoff : {10, 30, 100, 300, 1000}) {
    const std::string name = "box_self_intersection_d, cutoff " + std::to_string(cutoff);
    const std::size_t largest_n = cutoff == 300 ? 10000000 : 1000000;
    methods.push_back({name, Answer::EXACT, largest_n, false,
                       on_points([=](const auto& points, double r, Tally& tally) {
                         box_intersection<CGAL::Sequential_tag>(points, r, cutoff, tally);
                       })});
#ifdef CGAL_LINKED_WITH_TBB
    methods.push_back({name + ", 2 threads", Answer::EXACT, 1000000, true,
                       on_points_in_parallel([=](const auto& points, double r, auto& tally) {
                         box_intersection<CGAL::Parallel_tag>(points, r, cutoff, tally);
                       })});
#endif
  }
}

} // namespace thick_benchmark
