// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "Contestant.h"

#include "methods/delaunay.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace thick_benchmark {

namespace {

template <class Kernel>
auto by_delaunay()
{
  return on_points<Tally, Kernel>([](const auto& points, double r, Tally& tally) {
    delaunay_search<Kernel>(points, is_near_exactly(points, r), tally);
  });
}

} // namespace

void add_delaunay(Contestants& all)
{
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  all.push_back({{"Delaunay EPICK + search", by_delaunay<Epick>()}, Precision::EXACT, 10000000});
  all.push_back(
    {{"Delaunay EPECK + search", by_delaunay<Epeck>()}, Precision::EXACT, 100000, true});
}

} // namespace thick_benchmark
