// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects with boxes in parallel: the same pairs, a stop that is obeyed, exceptions that come out.
// ThreadSanitizer watches these tests too.

#include "support/interval_traits.h"
#include "support/parallel_pairs.h"
#include "support/usual_kernels.h"

#include <CGAL/fixed_radius_near_neighbors.h>

#include <tbb/global_control.h>

using namespace test_support;

namespace {

// Rectangles of all sizes; more than a single task cuts.
std::vector<Epick::Iso_rectangle_2> rectangles()
{
  Random random(5);
  std::vector<Epick::Iso_rectangle_2> rectangles;
  for(int i = 0; i < 40000; ++i) {
    const double x = random.fixed_point(12), y = random.fixed_point(12);
    const double size = std::pow(random.uniform() + 1e-4, -0.8) / 1024;
    rectangles.emplace_back(x, y, x + size, y + random.below(3) * size);
  }
  return rectangles;
}

} // namespace

BOOST_AUTO_TEST_CASE(same_pairs_of_rectangles)
{
  const auto objects = rectangles();
  const Pairs expected
    = reported([&](auto collect) { CGAL::thick_self_intersection_d(objects, collect); });
  BOOST_CHECK_GT(expected.size(), objects.size());
  for(const std::size_t threads : {std::size_t(1), thread_count}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    check_pairs(std::to_string(threads) + " threads", expected, collected([&](const auto& add) {
      CGAL::thick_self_intersection_d<CGAL::Parallel_tag>(objects, add);
    }));
  }
  const std::size_t half = objects.size() / 2;
  const auto sets = split(objects, half);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  check_pairs("two sets", of_two_sets(expected, half), collected([&](const auto& add) {
    CGAL::thick_intersection_d<CGAL::Parallel_tag>(sets.first, sets.second, add);
  }));
}

// Segments, and points or balls of many sizes.
BOOST_AUTO_TEST_CASE(near_objects_of_two_types)
{
  Random random(6);
  std::vector<Epick::Segment_2> segments;
  std::vector<std::pair<Epick::Point_2, double>> balls;
  for(int i = 0; i < 20000; ++i) {
    const auto place = [&] { return random.fixed_point(10); };
    const double x = place(), y = place();
    segments.emplace_back(Epick::Point_2(x, y), Epick::Point_2(x + .01 * place(), y));
    balls.emplace_back(Epick::Point_2(place(), place()), i % 2 * .001 * place());
  }
  const auto bound = CGAL::within_distance(0x1p-9);
  const Pairs expected = reported([&](auto collect) {
    CGAL::fixed_radius_near_neighbors(segments, balls, bound, collect);
  });
  BOOST_CHECK_GT(expected.size(), segments.size() / 2);
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  check_pairs("near objects", expected, collected([&](const auto& add) {
    CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(segments, balls, bound, add);
  }));
  std::atomic<std::size_t> calls = 0;
  const auto stop = [&](std::size_t, std::size_t) { return ++calls < 1000; };
  BOOST_CHECK(
    !CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(segments, balls, bound, stop));
  BOOST_CHECK_LE(calls, 1000 + thread_count - 1);
}

BOOST_AUTO_TEST_CASE(search_of_rectangles_stops_throws_and_is_cancelled)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  const auto objects = rectangles();
  std::atomic<std::size_t> calls = 0;
  const auto search = [&](std::size_t stop_at, std::size_t throw_at, double limit) {
    calls = 0;
    const auto callback = [&](std::size_t, std::size_t) {
      const std::size_t call = ++calls;
      return call == throw_at ? throw std::runtime_error("enough") : call < stop_at;
    };
    const auto watch = CGAL::parameters::callback([&](double done) { return done < limit; });
    return CGAL::thick_self_intersection_d<CGAL::Parallel_tag>(objects, callback, watch);
  };
  constexpr std::size_t never = static_cast<std::size_t>(-1);
  BOOST_CHECK(search(never, never, 2));
  const std::size_t all = calls;
  BOOST_CHECK(!search(100, never, 2));
  BOOST_CHECK_GE(calls, 100u);
  BOOST_CHECK_LE(calls, 100u + thread_count - 1); // each thread is told at its next pair
  BOOST_CHECK_THROW(search(never, 1000, 2), std::runtime_error);
  BOOST_CHECK(!search(never, never, .3));
  BOOST_CHECK_LT(calls, all);
}

BOOST_AUTO_TEST_CASE(same_pairs_of_traits_with_intervals)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  for(const int dimension : {2, 3, 4}) {
    const Number_boxes boxes = boxes_of_all_sizes(dimension, 4000);
    Call_count calls = 0;
    const Interval_traits traits(dimension, calls);
    check_colored<CGAL::Parallel_tag>(boxes, traits);
    calls = 0;
    pairs_by_traits<CGAL::Parallel_tag>(boxes, traits);
    BOOST_CHECK_EQUAL(calls, all_meeting_pairs(boxes, dimension).size());
  }
}
