// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/rtree.h"
#include "methods.h"

namespace thick_benchmark {

void add_rtree(Methods& methods)
{
  methods.push_back({"Boost.Geometry rtree", Answer::EXACT, 1000000, false,
                     on_points([](const auto& points, double r, Tally& tally) {
                       rtree_search(points, r, tally);
                     })});
}

} // namespace thick_benchmark
