// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/delaunay.h"
#include "methods.h"

namespace thick_benchmark {

void add_delaunay_epick(Methods& methods)
{
  methods.push_back({"Delaunay EPICK + search", Answer::EXACT, 10000000, false,
                     on_points<Epick>([](const auto& points, double r, Tally& tally) {
                       delaunay_search<Epick>(points, r, tally);
                     })});
}

} // namespace thick_benchmark
