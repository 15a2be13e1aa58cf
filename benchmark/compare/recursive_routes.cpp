// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "compare/Contestant.h"

#include "methods/recursive_route.h"

namespace thick_benchmark {

namespace {

template <class Points>
using Traits_of = CGAL::Thick_point_traits_d<typename Points::value_type>;

auto by_recursive_route(Pivot pivot, Base_case base_case)
{
  return on_epick([=](const auto& points, double r, Tally& tally) {
    const Traits_of<std::decay_t<decltype(points)>> traits(CGAL::within_distance(r));
    search_by_variant(points, traits, {pivot, base_case, 0}, tally);
  });
}

} // namespace

void add_recursive_routes(Contestants& all)
{
  const auto add_variant = [&](const std::string& name, const auto& prepare) {
    all.push_back({{"[V03], " + name, prepare}, true, 1000000, true});
  };
  all.push_back({{"[V03]", by_recursive_route(Pivot::MEDIAN, Base_case::SWEEP)}, true,
                 10000000});
  add_variant("walk", by_recursive_route(Pivot::MEDIAN, Base_case::WALK));
  add_variant("dimension 0", by_recursive_route(Pivot::MEDIAN, Base_case::DIMENSION_ZERO));
  add_variant("random pivot", by_recursive_route(Pivot::RANDOM, Base_case::SWEEP));
  add_variant("random pivot, walk", by_recursive_route(Pivot::RANDOM, Base_case::WALK));
  add_variant("random pivot, dimension 0",
              by_recursive_route(Pivot::RANDOM, Base_case::DIMENSION_ZERO));
  add_variant("reach 2D", on_epick([](const auto& points, double r, Tally& tally) {
                using Point = typename std::decay_t<decltype(points)>::value_type;
                search_by_variant(points, Literal_reach_traits<Point>(r), Recursion_variant(),
                                  tally);
              }));
}

} // namespace thick_benchmark
