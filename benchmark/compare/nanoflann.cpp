// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/nanoflann.h"
#include "methods.h"

namespace thick_benchmark {

void add_nanoflann(Methods& methods)
{
  methods.push_back({"nanoflann", Answer::ROUNDED, 10000000, false,
                     on_points([](const auto& points, double r, Tally& tally) {
                       nanoflann_search(points, r, tally);
                     })});
}

} // namespace thick_benchmark
