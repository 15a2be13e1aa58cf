// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route with parts of any size, so that few points make many parts.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H

#include "pairs.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <vector>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;
using internal::Slab_tuning;

// Calls task(points) with the points as the slab route sees them, at least one: as doubles, and as
// 32-bit integers if a scale is usable, rounded ones and those of the grid.
template <int Dimension, class Point, class NT, class Task>
void with_near_points(const std::vector<Point>& points,
                      const CGAL::Distance_bound<NT>& distance_bound, const Task& task)
{
  using Elements = internal::Numbered_elements<std::vector<Point>>;
  using Near = internal::Near_points<Dimension, Elements>;
  using Scale = internal::Narrow_scale<Dimension>;
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
  task(near);
  std::array<internal::Interval, Dimension> box;
  for(int axis = 0; axis < Dimension; ++axis)
    box[axis] = near.interval(axis);
  const auto with_scale = [&](const Scale& scale) {
    if(scale.is_usable())
      task(internal::Narrow_points<Dimension, Near>(near, scale));
  };
  with_scale(Scale(box, near.filter()));
  if(profile.tier() == CGAL::Arithmetic_tier::DOUBLE)
    with_scale(Scale(box, profile.grid_exponent(), profile.units(),
                     is_within.first_square_beyond(profile.grid_exponent())));
}

// The pairs of points by slabs that are cut as `tuning` says: the same ones in whatever way the
// slab route sees the points.
template <int Dimension, class Point, class NT>
Pairs slab_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& distance_bound,
                 const Slab_tuning& tuning,
                 std::optional<std::size_t> first_set_size = std::nullopt)
{
  std::optional<Pairs> pairs;
  const auto check = [&](const auto& near) {
    const internal::Slab_route<CGAL::Sequential_tag, std::decay_t<decltype(near)>> route(near,
                                                                                         tuning);
    Pairs found;
    auto callback = [&](std::size_t i, std::size_t j) { found.emplace_back(i, j); };
    internal::Pair_reporter<decltype(callback)> report(callback);
    internal::Unwatched_progress progress;
    if(first_set_size)
      route.search(internal::Two_sets{*first_set_size}, report, progress);
    else
      route.search(internal::One_set(), report, progress);
    if(!pairs)
      pairs = found;
    BOOST_REQUIRE_MESSAGE(sorted(found) == sorted(*pairs), compare(*pairs, found));
  };
  if(points.empty())
    return {};
  with_near_points<Dimension>(points, distance_bound, check);
  return *pairs;
}

// The lists of neighbors by slabs that are cut as `tuning` says, likewise.
template <class ConcurrencyTag, int Dimension, class Point, class NT>
CGAL::Neighbor_lists slab_lists(const std::vector<Point>& points,
                                const CGAL::Distance_bound<NT>& distance_bound,
                                const Slab_tuning& tuning)
{
  using Collector = internal::Neighbor_collector<ConcurrencyTag>;
  std::optional<CGAL::Neighbor_lists> lists;
  const auto check = [&](const auto& near) {
    const internal::List_route<ConcurrencyTag, std::decay_t<decltype(near)>> route(near, tuning);
    Collector collector(points.size());
    internal::Pair_reporter<Collector> report(collector);
    internal::Unwatched_progress progress;
    route.search(internal::One_set(), collector, report, progress);
    const CGAL::Neighbor_lists found = collector.lists();
    if(!lists)
      lists = found;
    for(std::size_t i = 0; i < points.size(); ++i)
      BOOST_REQUIRE(std::equal((*lists)[i].begin(), (*lists)[i].end(), found[i].begin(),
                               found[i].end()));
  };
  if(points.empty())
    return Collector(0).lists();
  with_near_points<Dimension>(points, distance_bound, check);
  return *lists;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
