// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/delaunay.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace thick_benchmark {

void add_delaunay_epeck(Contestants& all)
{
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto delaunay = on_points<Tally, Epeck>([](const auto& points, double r, Tally& tally) {
    delaunay_search<Epeck>(points, is_near_exactly(points, r), tally);
  });
  all.push_back({{"Delaunay EPECK + search", delaunay}, true, 100000, true});
}

} // namespace thick_benchmark
