// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route with parts of any size, so that few points make many parts.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H

#include "pairs.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <optional>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Slab_tuning;

// The pairs of points by slabs that are cut as `tuning` says.
template <int Dimension, class Point, class NT>
Pairs slab_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& distance_bound,
                 const Slab_tuning& tuning,
                 std::optional<std::size_t> first_set_size = std::nullopt)
{
  using Elements = internal::Numbered_elements<std::vector<Point>>;
  using Near = internal::Near_points<Dimension, Elements>;
  Pairs pairs;
  if(points.empty())
    return pairs;
  const Elements elements(points);
  internal::Doubles<Elements> doubles(elements);
  const internal::Scene scene = internal::scan_points<CGAL::Sequential_tag>(
    elements, "point",
    [&](std::size_t position, int axis, double x) { doubles.set(position, axis, x); });
  const internal::Squared_bound<internal::Exact_number_t<internal::Coordinate_t<Point>>> bound(
    distance_bound);
  const internal::Is_within_distance<Point> is_within(
    bound, scene,
    internal::first_exact_tier(bound.reach(), scene.grid_exponent, scene.extended_axis_count()));
  const Near near(elements, scene, doubles, is_within);
  const internal::Slab_route<CGAL::Sequential_tag, Near> route(near, tuning);
  auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  internal::Pair_reporter<decltype(callback)> report(callback);
  internal::Unwatched_progress progress;
  if(first_set_size)
    route.search(internal::Two_sets{*first_set_size}, report, progress);
  else
    route.search(internal::One_set(), report, progress);
  return pairs;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
