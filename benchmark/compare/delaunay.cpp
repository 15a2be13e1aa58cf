// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/delaunay.h"

namespace thick_benchmark {

void add_delaunay(Contestants& all)
{
  const auto delaunay = on_epick([](const auto& points, double r, Tally& tally) {
    delaunay_search<Epick>(points, is_near_exactly(points, r), tally);
  });
  all.push_back({{"Delaunay EPICK + search", delaunay}, true, 10000000});
}

} // namespace thick_benchmark
