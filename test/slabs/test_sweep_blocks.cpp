// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blocks of slabs, which threads take: each slab is swept once, and a thread that takes blocks that
// follow each other begins once.

#include "support/point_source.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/sweep_blocks.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <thread>

BOOST_AUTO_TEST_SUITE(sweep_blocks)

using namespace test_support;
using internal::Place;
using internal::Threads;

using Point = internal::Slab_point<2, double>;

struct Sweeper
{
  Place column;
  Place next;
  std::thread::id thread = std::this_thread::get_id();
  bool is_used = false;
};

// What is found out about a search, by any of its threads.
struct Record
{
  explicit Record(std::size_t slab_count) : times(slab_count) {}

  std::vector<std::atomic<int>> times; // how often each slab is swept
  std::atomic<int> sweepers = 0;
  std::atomic<bool> are_shared = false;     // between two threads
  std::atomic<bool> are_used_twice = false; // at the same time, by a thread that waits
  std::atomic<bool> leave_columns = false;
};

void sweep_slabs(const internal::Slabs<Point>& slabs, const Threads& threads, Record& record)
{
  internal::Stop_flag stop;
  internal::sweep_blocks<Sweeper>(
    slabs, threads, stop,
    [&](Place column, Place first) {
      ++record.sweepers;
      return std::make_unique<Sweeper>(Sweeper{column, first});
    },
    [&](Sweeper& sweeper, Place last) {
      if(sweeper.thread != std::this_thread::get_id())
        record.are_shared = true;
      if(std::exchange(sweeper.is_used, true))
        record.are_used_twice = true;
      if(last > slabs.count())
        record.leave_columns = true;
      threads.run_blocks(16, [](std::size_t, std::size_t) {}); // may take another block of slabs
      for(; sweeper.next < last; ++sweeper.next)
        ++record.times[sweeper.column * slabs.count() + sweeper.next];
      sweeper.is_used = false;
    });
}

// Calls use(slabs, threads) with slabs in one column and in several ones.
template <class ConcurrencyTag, class Use>
void with_slabs(ConcurrencyTag tag, const Use& use)
{
  internal::Slab_tuning tuning;
  tuning.points_per_slab = tuning.points_per_column = 16;
  const Points uniform = uniform_points(2, 20000, 0, 1, 1);
  Points uneven = uniform; // blocks hold the end of a column and the begin of the next one
  for(Coordinates& c : uneven)
    c[0] = std::pow(c[0], 8);
  for(const Points& points : {uniform, uneven})
    for(const double reach : {0.002, 0.02})
      use(internal::Slabs<Point>(Point_source<2>(points).reader(), reach, internal::Point_sets(),
                                 Threads(tag), tuning),
          Threads(tag));
}

// Returns how many sweepers there were for a column, on average.
double check_sweeps(const internal::Slabs<Point>& slabs, const Threads& threads)
{
  Record record(slabs.slab_count());
  sweep_slabs(slabs, threads, record);
  for(Place slab = 0; slab < slabs.slab_count(); ++slab)
    BOOST_CHECK_EQUAL(record.times[slab] == 1, slabs.size(slab) > 0 || record.times[slab] > 0);
  BOOST_CHECK(!record.are_shared);
  BOOST_CHECK(!record.are_used_twice);
  BOOST_CHECK(!record.leave_columns);
  return static_cast<double>(record.sweepers.load()) / slabs.columns().count();
}

BOOST_AUTO_TEST_CASE(a_sequence_has_one_sweeper)
{
  with_slabs(CGAL::Sequential_tag(), [](const auto& slabs, const Threads& threads) {
    BOOST_CHECK_EQUAL(slabs.columns().count(), 1u);
    BOOST_CHECK_EQUAL(check_sweeps(slabs, threads), 1);
  });
}

// The work is divided for 16 threads. One that does all of it makes no slab ready twice.
BOOST_AUTO_TEST_CASE(one_thread_in_the_place_of_many_has_one_sweeper_for_each_column)
{
  std::vector<Place> columns;
  tbb::task_arena(16, 16).execute([&] {
    with_slabs(CGAL::Parallel_tag(), [&](const auto& slabs, const Threads& threads) {
      columns.push_back(slabs.columns().count());
      BOOST_CHECK_EQUAL(threads.block_count(), 64u);
      BOOST_CHECK_LE(check_sweeps(slabs, threads), 1);
    });
  });
  BOOST_CHECK_EQUAL(columns.front(), 1u);
  BOOST_CHECK_GT(columns.back(), 3u);
}

BOOST_AUTO_TEST_CASE(threads_have_sweepers_of_their_own)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena(4).execute([] {
    for(int round = 0; round < 20; ++round)
      with_slabs(CGAL::Parallel_tag(), [](const auto& slabs, const Threads& threads) {
        BOOST_CHECK_GT(check_sweeps(slabs, threads), 0);
      });
  });
}

BOOST_AUTO_TEST_SUITE_END()
