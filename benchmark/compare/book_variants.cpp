// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "../rivals/book_route.h"
#include "methods.h"

namespace thick_benchmark {

void add_book_variants(Methods& methods)
{
  const auto by_the_book = [](Pivot pivot, Base_case base_case) {
    return on_points([=](const auto& points, double r, Tally& tally) {
      using Point = typename std::decay_t<decltype(points)>::value_type;
      const CGAL::Thick_point_traits_d<Point> traits(CGAL::within_distance(r));
      book_route(points, traits, {pivot, base_case, 0}, tally);
    });
  };
  const auto add = [&](const char* name, bool is_variant, auto prepare) {
    methods.push_back({name, Answer::EXACT, is_variant ? 1000000u : 10000000u, is_variant,
                       prepare});
  };
  add("[V03]", false, by_the_book(Pivot::MEDIAN, Base_case::SWEEP));
  add("[V03], walk", true, by_the_book(Pivot::MEDIAN, Base_case::WALK));
  add("[V03], dimension 0", true, by_the_book(Pivot::MEDIAN, Base_case::DIMENSION_ZERO));
  add("[V03], random pivot", true, by_the_book(Pivot::RANDOM, Base_case::SWEEP));
  add("[V03], random pivot, walk", true, by_the_book(Pivot::RANDOM, Base_case::WALK));
  add("[V03], random pivot, dimension 0", true,
      by_the_book(Pivot::RANDOM, Base_case::DIMENSION_ZERO));
  add("[V03], reach 2D", true, on_points([](const auto& points, double r, Tally& tally) {
        using Point = typename std::decay_t<decltype(points)>::value_type;
        book_route(points, Literal_reach_traits<Point>(r), Book_options(), tally);
      }));
}

} // namespace thick_benchmark
