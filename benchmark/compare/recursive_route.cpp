// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "support/recursion_variants.h"

#include <CGAL/Thick_point_traits_d.h>

namespace thick_benchmark {

void add_recursive_route(Contestants& all)
{
  const auto recursive_route = on_epick([](const auto& points, double r, Tally& tally) {
    using Point = typename std::decay_t<decltype(points)>::value_type;
    const CGAL::Thick_point_traits_d<Point> traits(CGAL::within_distance(r));
    test_support::search_by_variant(points, traits, {}, tally);
  });
  all.push_back({{"[V03]", recursive_route}, true, 10000000});
}

} // namespace thick_benchmark
