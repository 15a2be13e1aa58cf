// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "recursive_route.h"

#include "ours.h"

#include <CGAL/Simple_cartesian.h>

namespace thick_benchmark {

Tally tally_by_recursive_route(const Scene& scene)
{
  return on_points<Tally, CGAL::Simple_cartesian<double>>(
    [](const auto& points, double r, Tally& tally) {
      using Point = typename std::decay_t<decltype(points)>::value_type;
      const CGAL::Thick_point_traits_d<Point> traits(CGAL::within_distance(r));
      search_by_variant(points, traits, Recursion_variant(), tally);
    })(scene)();
}

} // namespace thick_benchmark
