// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Threads share indices out: each index is in one block, whatever the number of blocks. What one of
// them throws stops the others.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <atomic>
#include <vector>

BOOST_AUTO_TEST_SUITE(Threads)

using namespace test_support;

// How often each index is in a block that run(threads, take) makes, by take(first, last).
template <class ConcurrencyTag, class Run>
void check_indices(std::size_t count, const Run& run)
{
  std::vector<std::atomic<int>> times(count);
  run(internal::Threads(ConcurrencyTag()), [&](std::size_t first, std::size_t last) {
    for(; first < last; ++first)
      ++times.at(first); // several threads may not call Boost.Test at the same time
  });
  BOOST_CHECK(std::all_of(times.begin(), times.end(), [](const auto& n) { return n == 1; }));
}

template <class ConcurrencyTag>
void check_all_indices()
{
  for(const std::size_t count : {0, 1, 2, 7, 1000}) {
    check_indices<ConcurrencyTag>(count, [&](const internal::Threads& threads, const auto& take) {
      threads.run_blocks(count, take);
    });
    check_indices<ConcurrencyTag>(count, [&](const internal::Threads& threads, const auto& take) {
      threads.run_each(count, take);
    });
    for(const std::size_t blocks : {1, 3, 64})
      check_indices<ConcurrencyTag>(count, [&](const internal::Threads& threads, const auto& take) {
        threads.run_numbered_blocks(
          blocks, count, [&](std::size_t, std::size_t first, std::size_t last) {
            take(first, last);
          });
      });
  }
}

BOOST_AUTO_TEST_CASE(each_index_is_in_one_block)
{
  check_all_indices<CGAL::Sequential_tag>();
  check_all_indices<CGAL::Parallel_tag>();
}

BOOST_AUTO_TEST_CASE(what_a_block_throws_sets_the_flag)
{
  internal::Stop_flag stop;
  const auto fail = [](std::size_t, std::size_t) { throw 7; };
  BOOST_CHECK_THROW(stop.run_blocks(internal::Threads(), 1, fail), int);
  BOOST_CHECK(stop.is_set());
}

BOOST_AUTO_TEST_SUITE_END()
