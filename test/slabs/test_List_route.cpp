// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lists of neighbors by slabs, in sequence and in blocks of slabs, against pairs by the recursive
// route.

#define BOOST_TEST_MODULE list_route
#include "support/kernels.h"
#include "support/point_generators.h"
#include "support/slab_variants.h"

#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>

#include <tbb/global_control.h>

#include <mutex>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;

namespace {

// Many slabs and strips of few points, cut again and again.
Slab_tuning small_tuning(Random& random)
{
  Slab_tuning tuning;
  tuning.candidates_per_block = 1 + static_cast<double>(random.below(64));
  tuning.points_per_slab = static_cast<internal::Place>(1 + random.below(8));
  tuning.points_per_strip = static_cast<internal::Place>(1 + random.below(3));
  tuning.points_per_sorted_strip = static_cast<internal::Place>(1 + random.below(4));
  tuning.points_per_column = static_cast<internal::Place>(1 + random.below(8));
  tuning.max_slab_size = static_cast<internal::Place>(4 << random.below(8));
  return tuning;
}

// One slab, or a few, in many columns.
Slab_tuning few_slabs()
{
  Slab_tuning tuning;
  tuning.points_per_column = 8;
  return tuning;
}

Pairs pairs_of(const CGAL::Neighbor_lists& lists)
{
  Pairs pairs;
  for(std::size_t i = 0; i < lists.size(); ++i) {
    BOOST_CHECK(std::is_sorted(lists[i].begin(), lists[i].end()));
    for(const std::size_t j : lists[i])
      pairs.emplace_back(i, j);
  }
  return pairs;
}

// The pairs by slabs that threads sweep, and that are cut into columns if they are few.
template <int Dimension, class Point>
void check_pairs(const std::vector<Point>& points, const CGAL::Distance_bound<double>& bound,
                 const Slab_tuning& tuning, const Pairs& expected)
{
  const auto check = [&](auto number, auto& near, internal::Near_task<Dimension> task) {
    std::mutex mutex;
    Pairs found;
    auto callback = [&](std::size_t i, std::size_t j) {
      const std::lock_guard<std::mutex> lock(mutex);
      found.emplace_back(i, j);
    };
    internal::Callback_taker<internal::One_set, decltype(callback)> taker({}, callback);
    task.threads = internal::Threads(CGAL::Parallel_tag());
    using Slab_point = internal::Slab_point<Dimension, decltype(number)>;
    internal::Slab_route<Slab_point>(near, task, tuning).search(taker);
    BOOST_CHECK(sorted(found) == sorted(expected));
  };
  with_near_tasks<Dimension>(points, bound, check);
}

template <int Dimension>
void check_lists(const Points& points, double r, Random& random)
{
  const auto made = make_points<Cartesian_points<Kernel, Dimension>>(points);
  const auto bound = CGAL::within_distance(r);
  Pairs expected;
  const Pairs pairs = near_pairs_by_recursion(made, bound, Dimension);
  for(const Pair& p : pairs) {
    expected.push_back(p);
    expected.emplace_back(p.second, p.first);
  }
  expected = sorted(expected);
  for(const Slab_tuning& tuning : {Slab_tuning(), few_slabs(), small_tuning(random)}) {
    check_pairs<Dimension>(made, bound, tuning, pairs);
    BOOST_CHECK(
      pairs_of(slab_lists<CGAL::Sequential_tag, Dimension>(made, bound, tuning)) == expected);
    BOOST_CHECK(
      pairs_of(slab_lists<CGAL::Parallel_tag, Dimension>(made, bound, tuning)) == expected);
  }
}

// Lists of no neighbor, of few and of many; on the lattice, the reach is a tie.
template <int Dimension>
void check_scenes()
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  Random random(Dimension);
  const int side = Dimension == 2 ? 25 : 8;
  for(int round = 0; round < 5; ++round)
    for(const double r : {0., 0.01, 0.1, 0.3, 0.5}) {
      check_lists<Dimension>(uniform_points(Dimension, 700, 0, 1, random.below(1000)), r, random);
      check_lists<Dimension>(flight_points(Dimension, 500), 10 * r, random);
      check_lists<Dimension>(lattice_points(Dimension, side, 0.1, 0), r, random);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(lists_are_the_pairs_2) { check_scenes<2>(); }
BOOST_AUTO_TEST_CASE(lists_are_the_pairs_3) { check_scenes<3>(); }

// If most points are in one slab, threads share it. Then pairs are collected.
BOOST_AUTO_TEST_CASE(lists_of_crowded_slabs)
{
  Random random(1);
  Points points = uniform_points(2, 2000, 0, 1, 1);
  for(std::size_t i = 0; i < 1000; ++i)
    points[i][1] = 0.5 + points[i][1] / 1000;
  check_lists<2>(points, 0.02, random);
}
