// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/ann.h"
#include "methods.h"

namespace thick_benchmark {

void add_ann(Methods& methods)
{
  methods.push_back({"ANN", Answer::ROUNDED, 1000000, true,
                     on_points([](const auto& points, double r, Tally& tally) {
                       ann_search(points, r, tally);
                     })});
}

} // namespace thick_benchmark
