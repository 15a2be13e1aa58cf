// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A thread that makes a value does nothing else until the value is there.

#include "support/parallel_pairs.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/features/Values_on_demand.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <thread>

BOOST_AUTO_TEST_SUITE(Values_on_demand)

using namespace test_support;

thread_local bool is_making = false;

// Waits for something that other threads do, if there are any.
template <class Condition>
void wait_until(const Condition& holds)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while(!holds() && std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
}

// The thread waits for a task of the function that makes the value, which another thread has, and
// it has locked positions. If it took a task that asks for one of them, it would wait for itself.
BOOST_AUTO_TEST_CASE(a_thread_that_makes_a_value_takes_no_other_task)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, thread_count);
  std::atomic<int> begun = 0, made = 0, taken = 0;
  std::atomic<bool> is_over = false;
  const auto make = [&] {
    is_making = true;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, 2), [&](const auto&) {
      ++begun;
      if(is_making)
        wait_until([&] { return begun == 2; });
      else
        wait_until([&] { return is_over.load(); });
    }, tbb::simple_partitioner());
    is_making = false;
    return ++made;
  };
  const internal::Threads threads{CGAL::Parallel_tag()};
  const internal::Values_on_demand<int> values(1, threads);
  const auto work = [&](std::size_t, std::size_t) {
    taken += is_making;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  tbb::task_arena(static_cast<int>(thread_count)).execute([&] {
    threads.run_each(2, [&](std::size_t index, std::size_t) {
      if(index == 0)
        values.get(0, make);
      else {
        wait_until([&] { return begun == 2; });
        threads.run_each(30, work);
        is_over = true;
      }
    });
  });
  BOOST_CHECK_EQUAL(taken, 0);
  BOOST_CHECK_EQUAL(values.get(0, make), 1);
}

BOOST_AUTO_TEST_SUITE_END()
