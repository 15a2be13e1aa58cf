// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Thick_intersection_d/internal/closest_pair/Step_budget.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(Step_budget)

namespace internal = CGAL::Thick_intersection_d::internal;

std::size_t count_steps(internal::Step_counter& counter, std::size_t wanted)
{
  std::size_t steps = 0;
  while(steps < wanted && counter.step())
    ++steps;
  return steps;
}

BOOST_AUTO_TEST_CASE(one_task_may_take_all_steps)
{
  internal::Step_budget budget(10000);
  BOOST_CHECK(!budget.is_used());
  internal::Step_counter counter(budget);
  BOOST_CHECK_EQUAL(count_steps(counter, 10000), 10000);
  BOOST_CHECK(budget.is_used());
  BOOST_CHECK(!budget.is_exceeded());
  BOOST_CHECK(!counter.step());
  BOOST_CHECK(budget.is_exceeded());
}

// Tasks of a join in parallel, each with the fewest entries, take a step for each of these.
BOOST_AUTO_TEST_CASE(many_tasks_of_few_steps_leave_steps_for_each_other)
{
  constexpr std::size_t tasks = 1024, entries = internal::min_entries_per_list / 2;
  internal::Step_budget budget(tasks * entries * internal::max_steps_per_point);
  std::vector<internal::Step_counter> counters(tasks, internal::Step_counter(budget));
  for(internal::Step_counter& counter : counters)
    BOOST_CHECK_EQUAL(count_steps(counter, entries), entries);
  BOOST_CHECK(!budget.is_exceeded());
}

BOOST_AUTO_TEST_SUITE_END()
