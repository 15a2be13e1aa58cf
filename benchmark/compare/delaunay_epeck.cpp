// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/delaunay.h"
#include "methods.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace thick_benchmark {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

void add_delaunay_epeck(Methods& methods)
{
  methods.push_back({"Delaunay EPECK + search", Answer::EXACT, 100000, true,
                     on_points<Epeck>([](const auto& points, double r, Tally& tally) {
                       delaunay_search<Epeck>(points, r, tally);
                     })});
}

} // namespace thick_benchmark
