// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/kd_tree.h"
#include "methods.h"

namespace thick_benchmark {

void add_kd_tree(Methods& methods)
{
  methods.push_back({"Kd_tree + Fuzzy_sphere", Answer::ROUNDED, 1000000, false,
                     on_points([](const auto& points, double r, Tally& tally) {
                       kd_tree_search<Epick>(points, r, tally);
                     })});
}

} // namespace thick_benchmark
