// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "ours.h"

#include "support/recursion_variants.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_point_traits_d.h>

namespace thick_benchmark {

Tally tally_by_recursive_route(const Scene& scene)
{
  return on_points<Tally, CGAL::Simple_cartesian<double>>(
    [](const auto& points, double r, Tally& tally) {
      using Point = typename std::decay_t<decltype(points)>::value_type;
      const CGAL::Thick_point_traits_d<Point> traits(CGAL::within_distance(r));
      test_support::search_by_variant(points, traits, {}, tally);
    })(scene)();
}

} // namespace thick_benchmark
