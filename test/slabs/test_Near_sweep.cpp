// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Sweeps of points report each near pair once, the smaller position first; in blocks, each block
// its share.

#include "support/pairs.h"
#include "support/point_source.h"
#include "support/run_of_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/near_points/Callback_taker.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>

#include <CGAL/Arithmetic_tier.h>

BOOST_AUTO_TEST_SUITE(Near_sweep)

using namespace test_support;

using Point = internal::Slab_point<2, double>;

// Pairs at most 1 apart along axis 0. The lanes decide all of them, or none, and then each second
// one is a pair.
struct Near_along_axis_0 : Point_source<2>
{
  explicit Near_along_axis_0(const Points& no_points = {}) : Point_source<2>(no_points) {}

  bool is_pair(std::size_t i, std::size_t j, internal::Decision_counts& counts) const override
  {
    counts.add(CGAL::Arithmetic_tier::INT64);
    return (i + j) % 2 == 0;
  }
};

// The filter leaves undecided what lanes do.
internal::Near_task<2> undecided_task()
{
  internal::Near_task<2> task;
  task.near = {1, 1, {-1, 1}};
  return task;
}

const internal::Near_question<double> decided = {1, 1, 1};
const internal::Near_question<double> undecided = {1, -1, 1};

Points points_on_line(std::size_t size, std::size_t side, Random& random)
{
  return embedded(integer_points(1, size, side, random), 2);
}

// The runs are of one set if `b` is null. Positions of b may be the smaller ones.
Pairs by_brute_force(const Run_of_points<2>& a, const Run_of_points<2>* b, bool is_each_second)
{
  Pairs pairs;
  const Run_of_points<2>& other = b ? *b : a;
  for(std::size_t i = 0; i < a.points().size(); ++i)
    for(std::size_t j = b ? 0 : i + 1; j < other.points().size(); ++j) {
      const std::size_t p = a.run().positions[i], q = other.run().positions[j];
      if(std::fabs(a.points()[i][0] - other.points()[j][0]) <= 1
         && (!is_each_second || (p + q) % 2 == 0))
        pairs.push_back(std::minmax(p, q));
    }
  return sorted(pairs);
}

// Calls use(sweep) with a sweep that reports to the callback.
template <class Callback, class Use>
void with_sweep(const internal::Near_question<double>& question, Callback callback, const Use& use)
{
  internal::Callback_taker<internal::One_set, Callback> taker({}, callback);
  const Near_along_axis_0 near;
  const internal::Near_task<2> task = undecided_task();
  internal::Stop_flag stop;
  internal::Near_sweep<Point> sweep(question, near, task, taker, stop);
  use(sweep);
}

// Sweeps all blocks. The blocks have no pair in common.
Pairs by_sweeps(const Run_of_points<2>& a, const Run_of_points<2>* b,
                const internal::Near_question<double>& question, internal::Place block_count)
{
  Pairs pairs;
  with_sweep(question, Pair_collector{pairs}, [&](auto& sweep) {
    for(internal::Place block = 0; block < block_count; ++block) {
      sweep.take_block(block, block_count);
      if(b)
        sweep.between(a.run(), b->run());
      else
        sweep.within(a.run());
    }
    BOOST_CHECK(!sweep.is_stopped());
  });
  return sorted(pairs);
}

void check_runs(std::size_t size, std::size_t other_size, std::size_t side)
{
  Random random(size);
  const Run_of_points<2> a(points_on_line(size, side, random), 50);
  const Run_of_points<2> b(points_on_line(other_size, side, random), size % 2 == 0 ? 0 : 1000);
  for(const internal::Place blocks : {1, 2, 3, 7, 64}) {
    BOOST_CHECK(by_sweeps(a, nullptr, decided, blocks) == by_brute_force(a, nullptr, false));
    BOOST_CHECK(by_sweeps(a, &b, decided, blocks) == by_brute_force(a, &b, false));
    BOOST_CHECK(by_sweeps(a, nullptr, undecided, blocks) == by_brute_force(a, nullptr, true));
    BOOST_CHECK(by_sweeps(a, &b, undecided, blocks) == by_brute_force(a, &b, true));
  }
}

BOOST_AUTO_TEST_CASE(all_blocks_together_report_each_pair_once)
{
  for(std::size_t size = 0; size <= 40; ++size)
    check_runs(size, (11 * size) % 41, 15);
  check_runs(200, 45, 10); // candidates by the thousand
}

BOOST_AUTO_TEST_CASE(each_candidate_is_counted_once)
{
  const Run_of_points<2> a(identical_points(2, 100, 1));
  const auto ignore = [](std::size_t, std::size_t) {};
  for(const internal::Near_question<double>& question : {decided, undecided})
    with_sweep(question, ignore, [&](auto& sweep) {
      sweep.within(a.run());
      const bool by_lanes = question.inside == 1;
      BOOST_CHECK_EQUAL(sweep.counts()[CGAL::Arithmetic_tier::DOUBLE], by_lanes ? 4950u : 0u);
      BOOST_CHECK_EQUAL(sweep.counts()[CGAL::Arithmetic_tier::INT64], by_lanes ? 0u : 4950u);
    });
}

BOOST_AUTO_TEST_CASE(a_sweep_stops_when_the_report_says_so)
{
  const Run_of_points<2> a(identical_points(2, 200, 1));
  int calls = 0;
  const auto stop = [&](std::size_t, std::size_t) { return ++calls < 10; };
  with_sweep(decided, stop, [&](auto& sweep) {
    sweep.within(a.run());
    BOOST_CHECK(sweep.is_stopped());
  });
  BOOST_CHECK_EQUAL(calls, 10);
}

BOOST_AUTO_TEST_SUITE_END()
