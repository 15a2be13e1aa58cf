// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The slab route with parts of any size, so that few points make many parts.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H

#include "pairs.h"
#include "unit_test.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <CGAL/Thick_intersection_d/internal/slabs/List_route.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_route.h>

namespace test_support {

using internal::Slab_tuning;

// Calls search(number, points, task) with the points as the slab route sees them, at least one: as
// doubles, and as 32-bit integers if a scale is usable, rounded ones and those of the grid. The
// type of `number` is that of the numbers in slabs.
template <int Dimension, class Point, class NT, class Search>
void with_near_tasks(const std::vector<Point>& points,
                     const CGAL::Distance_bound<NT>& distance_bound, const Search& search)
{
  using Elements = internal::Numbered_elements<std::vector<Point>>;
  using Scale = internal::Narrow_scale<Dimension>;
  const Elements elements(points);
  internal::Doubles<Elements> doubles(elements);
  const internal::Scene scene = internal::scan_points(
    elements, "point", true,
    [&](std::size_t position, int axis, double x) { doubles.set(position, axis, x); },
    internal::Threads());
  const internal::Squared_bound<internal::Exact_number_t<internal::Coordinate_t<Point>>> bound(
    distance_bound);
  const CGAL::Scene_profile profile(scene, bound.reach());
  const internal::Is_within_distance<Point> is_within(bound, scene, profile.tier());
  internal::Unwatched_progress progress;
  internal::Element_points<Dimension, Elements, internal::Unwatched_progress> near(
    elements, doubles, is_within, progress);
  internal::Near_task<Dimension> task;
  std::copy_n(scene.box.begin(), Dimension, task.box.begin());
  task.near = is_within.filter_of_doubles();
  search(double(), near, task);
  std::array<internal::Interval, Dimension> box = task.box;
  for(internal::Interval& interval : box)
    interval = {interval.low * task.near.scale, interval.high * task.near.scale};
  const auto search_with = [&](const Scale& scale) {
    task.scale = scale;
    if(scale.is_usable())
      search(std::int32_t(), near, task);
  };
  search_with(Scale(box, task.near.filter));
  if(profile.tier() == CGAL::Arithmetic_tier::DOUBLE)
    search_with(Scale(box, profile.grid_exponent(), profile.units(),
                      is_within.first_square_beyond(profile.grid_exponent())));
}

// Many slabs and strips of few points, cut again and again.
inline Slab_tuning small_tuning(Random& random)
{
  Slab_tuning tuning;
  tuning.candidates_per_block = static_cast<double>(random.below(64)) + 1;
  tuning.points_per_slab = static_cast<internal::Place>(1 + random.below(8));
  tuning.points_per_strip = static_cast<internal::Place>(1 + random.below(3));
  tuning.points_per_sorted_strip = static_cast<internal::Place>(1 + random.below(4));
  tuning.max_slab_size = static_cast<internal::Place>(4 << random.below(4));
  return tuning;
}

// The pairs of points by slabs that are cut as `tuning` says: the same ones in whatever way the
// slab route sees the points.
template <int Dimension, class ConcurrencyTag = CGAL::Sequential_tag, class Point, class NT>
Pairs slab_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<NT>& distance_bound,
                 const Slab_tuning& tuning,
                 std::optional<std::size_t> first_set_size = std::nullopt)
{
  std::optional<Pairs> pairs;
  const auto check = [&](auto number, auto& near, internal::Near_task<Dimension> task) {
    Pairs found;
    Locked_collector callback(found);
    internal::Callback_taker<internal::One_set, Locked_collector> taker({}, callback);
    task.threads = internal::Threads(ConcurrencyTag());
    if(first_set_size)
      task.sets.first_size = static_cast<internal::Place>(*first_set_size);
    using Slab_point = internal::Slab_point<Dimension, decltype(number)>;
    internal::Slab_route<Slab_point>(near, task, tuning).search(taker);
    if(!pairs)
      pairs = found;
    BOOST_REQUIRE_MESSAGE(sorted(found) == sorted(*pairs), compare(*pairs, found));
  };
  if(points.empty())
    return {};
  with_near_tasks<Dimension>(points, distance_bound, check);
  return *pairs;
}

// The lists of neighbors by slabs that are cut as `tuning` says, likewise.
template <class ConcurrencyTag, int Dimension, class Point, class NT>
CGAL::Neighbor_lists slab_lists(const std::vector<Point>& points,
                                const CGAL::Distance_bound<NT>& distance_bound,
                                const Slab_tuning& tuning)
{
  const internal::Threads threads{ConcurrencyTag()};
  std::optional<CGAL::Neighbor_lists> lists;
  const auto check = [&](auto number, auto& near, internal::Near_task<Dimension> task) {
    internal::Neighbor_collector collector(points.size(), threads);
    internal::Collector_taker taker(collector);
    task.threads = threads;
    using Slab_point = internal::Slab_point<Dimension, decltype(number)>;
    internal::List_route<Slab_point>(near, task, tuning).search(taker);
    const CGAL::Neighbor_lists found = collector.lists();
    if(!lists)
      lists = found;
    for(std::size_t i = 0; i < points.size(); ++i)
      BOOST_REQUIRE(std::equal((*lists)[i].begin(), (*lists)[i].end(), found[i].begin(),
                               found[i].end()));
  };
  if(points.empty())
    return internal::Neighbor_collector(0, threads).lists();
  with_near_tasks<Dimension>(points, distance_bound, check);
  return *lists;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SLAB_VARIANTS_H
