// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// In parallel: the same pairs, the same lists and the same counts. How searches stop is in
// test_faults.

#include "support/check_pairs.h"
#include "support/parallel_pairs.h"
#include "support/kernels.h"
#include "support/usual_kernels.h"

#include <tbb/global_control.h>

using namespace test_support;

namespace {

// Scenes of more objects than a single task gets: ties, duplicates, clusters.
Points large_scene(int dimension)
{
  Points points = clustered_points(dimension, 20000, 50, 1. / 16, 1);
  for(const Coordinates& c : lattice_points(dimension, dimension == 2 ? 100 : 20, 1. / 64, -3))
    points.push_back(c);
  for(std::size_t i = 0; i < 2000; ++i)
    points.push_back(points[5 * i]);
  return shuffled(points, 2);
}

template <class Point>
Pairs parallel_pairs(const std::vector<Point>& points, double r)
{
  return collected([&](const auto& callback) {
    CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(points, CGAL::within_distance(r),
                                                          callback);
  });
}

template <class Point>
Pairs parallel_pairs_by_recursion(const std::vector<Point>& points, double r)
{
  return collected([&](const auto& callback) {
    CGAL::thick_self_intersection_d<CGAL::Parallel_tag>(
      points, callback,
      CGAL::parameters::geom_traits(
        CGAL::Thick_point_traits_d<Point>(CGAL::within_distance(r))));
  });
}

template <class Maker>
void check_same_pairs(int dimension)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  const auto points = make_points<Maker>(large_scene(dimension));
  for(const double r : {1. / 64, 1. / 32}) {
    const Pairs expected = near_pairs(points, CGAL::within_distance(r));
    BOOST_REQUIRE_GT(expected.size(), points.size());
    for(int repetition = 0; repetition < 3; ++repetition) {
      check_pairs("in parallel", expected, parallel_pairs(points, r));
      check_pairs("by recursion", expected, parallel_pairs_by_recursion(points, r));
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(same_pairs_epick_2) { check_same_pairs<Cartesian_points<Epick, 2>>(2); }
BOOST_AUTO_TEST_CASE(same_pairs_epick_3) { check_same_pairs<Cartesian_points<Epick, 3>>(3); }
BOOST_AUTO_TEST_CASE(same_pairs_epeck_2) { check_same_pairs<Cartesian_points<Epeck, 2>>(2); }

// Points at one place are in one slab, which is swept in shares, and watched.
BOOST_AUTO_TEST_CASE(crowds_are_shared_out)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  const std::size_t size = 12000;
  std::vector<Epick::Point_2> points(size, Epick::Point_2(1, 2));
  points.emplace_back(1000, 1000); // so that a search is needed
  std::vector<std::atomic<std::size_t>> neighbors(size + 1);
  const auto count = [&](std::size_t i, std::size_t j) {
    neighbors[i].fetch_add(1, std::memory_order_relaxed);
    neighbors[j].fetch_add(1, std::memory_order_relaxed);
  };
  std::size_t steps = 0;
  double last = 0;
  const auto watch = [&](double done) {
    steps += done > last;
    last = done;
    return true;
  };
  BOOST_CHECK(CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(
    points, CGAL::within_distance(1), count, CGAL::parameters::callback(watch)));
  BOOST_CHECK_GE(steps, 5u);
  BOOST_CHECK_EQUAL(last, 1);
  BOOST_CHECK_EQUAL(std::count(neighbors.begin(), neighbors.end() - 1, size - 1), size);
  BOOST_CHECK_EQUAL(neighbors.back(), 0u);
}

// The same lists for any number of threads.
BOOST_AUTO_TEST_CASE(neighbor_lists)
{
  for(int dimension : {2, 3}) {
    const auto check = [&](const auto& points) {
      const auto bound = CGAL::within_distance(1. / 64);
      const CGAL::Neighbor_lists lists = CGAL::fixed_radius_neighbor_lists(points, bound);
      BOOST_CHECK_GT(lists.number_of_pairs(), points.size());
      for(const std::size_t threads : {std::size_t(1), thread_count}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        BOOST_CHECK(CGAL::fixed_radius_neighbor_lists<CGAL::Parallel_tag>(points, bound) == lists);
      }
    };
    if(dimension == 2)
      check(make_points<Cartesian_points<Epick, 2>>(large_scene(2)));
    else
      check(make_points<Cartesian_points<Epick, 3>>(large_scene(3)));
  }
}

// Each thread counts for itself; nothing is counted twice or lost.
BOOST_AUTO_TEST_CASE(decisions_are_counted_as_in_sequence)
{
  const auto ignore = [](std::size_t, std::size_t) {};
  for(const double unit : {87654321., 0.1}) {
    const auto points
      = make_points<Cartesian_points<Epick, 3>>(shuffled(lattice_points(3, 30, unit), 3));
    const auto bound = CGAL::within_distance(3 * unit);
    for(const CGAL::Arithmetic_tier tier :
        {CGAL::Arithmetic_tier::INT128, CGAL::Arithmetic_tier::FILTERED_EXACT}) {
      CGAL::Scene_profile in_sequence, in_parallel;
      in_sequence.force_tier(tier);
      in_parallel.force_tier(tier);
      CGAL::fixed_radius_near_neighbors(points, bound, ignore, in_sequence);
      CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(points, bound, ignore, in_parallel);
      BOOST_CHECK_GT(in_sequence.decided(tier), 1000u);
      for(const CGAL::Arithmetic_tier each :
          {CGAL::Arithmetic_tier::DOUBLE, CGAL::Arithmetic_tier::INT64,
           CGAL::Arithmetic_tier::INT128, CGAL::Arithmetic_tier::FILTERED_EXACT})
        BOOST_CHECK_EQUAL(in_parallel.decided(each), in_sequence.decided(each));
    }
  }
}
