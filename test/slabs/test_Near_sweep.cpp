// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Sweeps of points count each candidate once, and stop when they are told. That blocks of a sweep
// report each near pair once, the smaller position first, is left to test_Slab_route.cpp.

#include "support/point_source.h"
#include "support/run_of_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/near_points/Callback_taker.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_sweep.h>

BOOST_AUTO_TEST_SUITE(Near_sweep)

using namespace test_support;

using Point = internal::Slab_point<2, double>;

// Decides what the lanes do not decide, which is all or nothing.
struct Counted_decisions : Point_source<2>
{
  explicit Counted_decisions(const Points& no_points = {}) : Point_source<2>(no_points) {}

  bool is_pair(std::size_t, std::size_t, internal::Decision_counts& counts) const override
  {
    counts.add(CGAL::Arithmetic_tier::INT64);
    return false;
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

// Calls use(sweep) with a sweep that reports to the callback.
template <class Callback, class Use>
void with_sweep(const internal::Near_question<double>& question, Callback callback, const Use& use)
{
  internal::Callback_taker<internal::One_set, Callback> taker({}, callback);
  const Counted_decisions near;
  const internal::Near_task<2> task = undecided_task();
  internal::Stop_flag stop;
  internal::Near_sweep<Point> sweep(question, near, task, taker, stop);
  use(sweep);
}

BOOST_AUTO_TEST_CASE(each_candidate_is_counted_once)
{
  const Run_of_points<2> a(identical_points(2, 100, 1));
  const auto ignore = [](std::size_t, std::size_t) {};
  for(const internal::Near_question<double>& question : {decided, undecided})
    with_sweep(question, ignore, [&](auto& sweep) {
      sweep.within(a.run());
      const bool by_lanes = question.inside == 1;
      const internal::Decision_counts counts = sweep.take_counts();
      BOOST_CHECK_EQUAL(counts[CGAL::Arithmetic_tier::DOUBLE], by_lanes ? 4950u : 0u);
      BOOST_CHECK_EQUAL(counts[CGAL::Arithmetic_tier::INT64], by_lanes ? 0u : 4950u);
      const internal::Decision_counts later = sweep.take_counts();
      BOOST_CHECK_EQUAL(later[CGAL::Arithmetic_tier::DOUBLE], 0u);
      BOOST_CHECK_EQUAL(later[CGAL::Arithmetic_tier::INT64], 0u);
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
