// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The record of tasks that run in turn, and the stand-in for oneTBB, with a clock that tasks set.

#include "tbb_in_turn.h"
#include "unit_test.h"

#include "point_source.h"

#include <CGAL/Thick_intersection_d/internal/machine/Per_thread.h>
#include <CGAL/Thick_intersection_d/internal/slabs/sweep_blocks.h>

BOOST_AUTO_TEST_SUITE(Task_record)

using namespace test_support;
using CGAL::Parallel_tag;
using thick_benchmark::Cost;
using thick_benchmark::Reading;

const internal::Threads threads{Parallel_tag()};
Reading now;

void take_time(std::int64_t time) { now.nanoseconds += time; }

void allocate(std::int64_t bytes)
{
  now.bytes += bytes;
  now.most_bytes = (std::max)(now.most_bytes, now.bytes);
}

Reading read()
{
  const Reading reading = now;
  now.most_bytes = now.bytes;
  return reading;
}

template <class Function>
thick_benchmark::Task_record record_of(std::size_t processors, const Function& function)
{
  return thick_benchmark::record_tasks(processors, read, function);
}

template <class Function>
Cost cost_of(std::size_t processors, const Function& function)
{
  return record_of(processors, function).cost();
}

// What takes `time` for each of `count` indices.
void take_time_for_each(std::size_t count, std::int64_t time)
{
  threads.run_blocks(count, [&](std::size_t first, std::size_t last) {
    take_time(time * static_cast<std::int64_t>(last - first));
  });
}

BOOST_AUTO_TEST_CASE(the_span_of_blocks_is_that_of_the_longest)
{
  const Cost cost = cost_of(2, [] {
    take_time(1);
    threads.run_numbered_blocks(
      3, 300, [](std::size_t block, std::size_t first, std::size_t last) {
        BOOST_CHECK_EQUAL(last - first, 100);
        take_time(block == 1 ? 50 : 10);
      });
    take_time(2);
  });
  BOOST_CHECK_EQUAL(cost.work, 1 + 10 + 50 + 10 + 2);
  BOOST_CHECK_EQUAL(cost.span, 1 + 50 + 2);
}

BOOST_AUTO_TEST_CASE(a_range_is_divided_into_four_blocks_for_each_processor)
{
  const Cost cost = cost_of(16, [] { take_time_for_each(6400, 1); });
  BOOST_CHECK_EQUAL(cost.work, 6400);
  BOOST_CHECK_EQUAL(cost.span, 100);
  BOOST_CHECK_EQUAL(cost_of(16, [] { take_time_for_each(0, 1); }).work, 0);
}

BOOST_AUTO_TEST_CASE(a_range_may_be_divided_into_all_of_its_indices)
{
  const Cost cost = cost_of(2, [] {
    threads.run_each(100, [](std::size_t first, std::size_t last) {
      BOOST_CHECK_EQUAL(last, first + 1);
      take_time(first == 7 ? 9 : 1);
    });
  });
  BOOST_CHECK_EQUAL(cost.work, 99 + 9);
  BOOST_CHECK_EQUAL(cost.span, 9);
}

BOOST_AUTO_TEST_CASE(tasks_within_tasks_are_on_the_chain)
{
  const Cost cost = cost_of(2, [] {
    threads.run_blocks(3, [](std::size_t task, std::size_t) {
      if(task == 0)
        take_time(20);
      if(task == 1) {
        take_time(3);
        take_time_for_each(8, 5); // in blocks of one
        take_time(4);
        take_time_for_each(8, 6);
      }
    });
    take_time(1);
  });
  BOOST_CHECK_EQUAL(cost.work, 20 + 3 + 40 + 4 + 48 + 1);
  BOOST_CHECK_EQUAL(cost.span, 20 + 1); // more than 3 + 5 + 4 + 6
  const Cost inner = cost_of(2, [] {
    threads.run_blocks(3, [](std::size_t task, std::size_t) {
      if(task == 0)
        take_time(10);
      if(task == 1) {
        take_time(3);
        take_time_for_each(8, 9);
      }
    });
  });
  BOOST_CHECK_EQUAL(inner.span, 3 + 9);
}

// What a processor has ready is not taken by another one, although tasks run in turn.
BOOST_AUTO_TEST_CASE(each_processor_begins_with_its_slabs_once)
{
  const Points points = uniform_points(2, 20000, 0, 1, 1);
  std::vector<internal::Place> begins;
  record_of(4, [&] {
    const auto slabs = slabs_of<2>(points, 0.001);
    internal::Stop_flag stop;
    internal::sweep_blocks<internal::Place>(
      slabs, threads, stop,
      [&](internal::Place, internal::Place first) {
        begins.push_back(first);
        return std::make_unique<internal::Place>(first);
      },
      [](internal::Place& next, internal::Place last) {
        BOOST_CHECK_LE(next, last);
        next = last;
      });
    BOOST_CHECK_GT(slabs.count(), 100u);
  });
  BOOST_CHECK_EQUAL(begins.size(), 4u);
  BOOST_CHECK(std::is_sorted(begins.begin(), begins.end()));
}

BOOST_AUTO_TEST_CASE(each_processor_has_its_value)
{
  std::set<const int*> values;
  std::size_t count = 0;
  record_of(5, [&] {
    internal::Per_thread<int> per_thread(0, threads);
    BOOST_CHECK_EQUAL(threads.block_count(), 20);
    threads.run_blocks(100, [&](std::size_t, std::size_t) {
      values.insert(&per_thread.local());
      ++per_thread.local();
    });
    per_thread.for_each([&](int blocks) {
      BOOST_CHECK_EQUAL(blocks, 4);
      ++count;
    });
  });
  BOOST_CHECK_EQUAL(values.size(), 5);
  BOOST_CHECK_EQUAL(count, 5);
}

BOOST_AUTO_TEST_CASE(tasks_within_tasks_share_the_processors_of_their_task)
{
  std::multiset<std::size_t> processors;
  const auto take_task = [&](std::size_t, std::size_t) {
    processors.insert(thick_benchmark::current_record()->processor());
  };
  record_of(6, [&] {
    threads.run_blocks(2, [&](std::size_t, std::size_t) {
      threads.run_blocks(3, take_task);
    });
  });
  const std::multiset<std::size_t> all = {0, 1, 2, 3, 4, 5};
  BOOST_CHECK(processors == all);
}

BOOST_AUTO_TEST_CASE(the_least_time_of_each_segment_counts)
{
  const auto run = [](std::int64_t first, std::int64_t second) {
    return record_of(2, [=] {
      take_time(first);
      take_time_for_each(1, second);
    });
  };
  thick_benchmark::Task_record record = run(10, 30);
  record.take_least_times(run(20, 5));
  BOOST_CHECK_EQUAL(record.cost().span, 15);
  BOOST_CHECK_THROW(record.take_least_times(record_of(2, [] {})), std::runtime_error);
}

// Two of three tasks run at a time. All of them keep 10 bytes, and one of them needs 100 more, one
// 30, and one 5.
BOOST_AUTO_TEST_CASE(each_processor_has_the_memory_of_a_task)
{
  const std::vector<std::int64_t> passing = {30, 100, 5};
  const Cost cost = cost_of(2, [&] {
    allocate(1000);
    threads.run_blocks(3, [&](std::size_t task, std::size_t) {
      allocate(10 + passing[task]);
      allocate(-passing[task]);
    });
    allocate(-1000);
  });
  BOOST_CHECK_EQUAL(cost.kept_bytes, 30);
  BOOST_CHECK_EQUAL(cost.most_bytes, 1000 + 30 + 100 + 30);
}

BOOST_AUTO_TEST_SUITE_END()
