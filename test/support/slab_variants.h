// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route with parts of any size, so that few points make many parts.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H

#include "pairs.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <optional>
#include <vector>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Slab_tuning;

// The pairs of one route.
template <class Test>
Pairs pairs_by_slabs_of(const Test& test, const Slab_tuning& tuning,
                        std::optional<std::size_t> first_set_size)
{
  const internal::Slab_route<CGAL::Sequential_tag, Test> route(test, tuning);
  Pairs pairs;
  auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  internal::Pair_reporter<decltype(callback)> report(callback);
  internal::Unwatched_progress progress;
  if(first_set_size)
    route.search(internal::Two_sets{*first_set_size}, report, progress);
  else
    route.search(internal::One_set(), report, progress);
  return pairs;
}

// The pairs of points by slabs that are cut as `tuning` says. They are the same with the points as
// doubles, and as 32-bit integers if a scale is usable: rounded ones, and those of the grid.
template <int Dimension, class Point, class NT>
Pairs slab_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& distance_bound,
                 const Slab_tuning& tuning,
                 std::optional<std::size_t> first_set_size = std::nullopt)
{
  using Elements = internal::Numbered_elements<std::vector<Point>>;
  using Near = internal::Near_points<Dimension, Elements>;
  using Scale = internal::Narrow_scale<Dimension>;
  if(points.empty())
    return {};
  const Elements elements(points);
  internal::Doubles<Elements> doubles(elements);
  const internal::Scene scene = internal::scan_points<CGAL::Sequential_tag>(
    elements, "point", true,
    [&](std::size_t position, int axis, double x) { doubles.set(position, axis, x); });
  const internal::Squared_bound<internal::Exact_number_t<internal::Coordinate_t<Point>>> bound(
    distance_bound);
  const CGAL::Scene_profile profile(scene, bound.reach());
  const internal::Is_within_distance<Point> is_within(bound, scene, profile.tier());
  const Near near(elements, scene, doubles, is_within);
  const Pairs pairs = pairs_by_slabs_of(near, tuning, first_set_size);
  const auto check = [&](const Scale& scale) {
    if(!scale.is_usable())
      return;
    const internal::Narrow_points<Dimension, Near> narrow(near, scale);
    const Pairs found = pairs_by_slabs_of(narrow, tuning, first_set_size);
    BOOST_REQUIRE_MESSAGE(sorted(found) == sorted(pairs),
                          "as integers of " << (scale.is_exact() ? "the grid" : "a scale") << ": "
                                            << compare(pairs, found));
  };
  std::array<internal::Interval, Dimension> box;
  for(int axis = 0; axis < Dimension; ++axis)
    box[axis] = near.interval(axis);
  check(Scale(box, near.filter()));
  if(profile.tier() == CGAL::Arithmetic_tier::DOUBLE)
    check(Scale(box, profile.grid_exponent(), profile.units(),
                is_within.first_square_beyond(profile.grid_exponent())));
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
