// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Prefix sums against sums that start anew.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>

BOOST_AUTO_TEST_SUITE(prefix_sums)

using namespace test_support;
using internal::Threads;
using internal::replace_by_prefix_sums;
using internal::replace_by_sums_over_blocks;

BOOST_AUTO_TEST_CASE(each_count_becomes_the_sum_of_those_before)
{
  Random random(2);
  for(std::ptrdiff_t size = 0; size < 50; ++size) {
    std::vector<std::uint32_t> counts;
    for(std::ptrdiff_t i = 0; i < size; ++i)
      counts.push_back(static_cast<std::uint32_t>(random.below(4)));
    std::vector<std::uint32_t> sums = counts;
    const std::uint32_t all = replace_by_prefix_sums(sums.data(), sums.data() + size);
    for(std::ptrdiff_t i = 0; i < size; ++i)
      BOOST_CHECK_EQUAL(sums[i], std::accumulate(counts.begin(), counts.begin() + i, 0u));
    BOOST_CHECK_EQUAL(all, std::accumulate(counts.begin(), counts.end(), 0u));
  }
}

// Several groups of buckets, the last of which is not full.
BOOST_AUTO_TEST_CASE(each_count_becomes_the_sum_of_those_in_blocks_before)
{
  Random random(3);
  for(const std::size_t blocks : {1, 2, 7})
    for(const std::size_t size : {1, 16, 50}) {
      std::vector<std::uint32_t> counts;
      for(std::size_t i = 0; i < blocks * size; ++i)
        counts.push_back(static_cast<std::uint32_t>(random.below(4)));
      std::vector<std::uint32_t> sums = counts;
      std::vector<std::uint64_t> totals(size, 0);
      replace_by_sums_over_blocks(Threads(), sums.data(), blocks, size, totals.data());
      for(std::size_t i = 0; i < size; ++i) {
        std::uint64_t sum = 0;
        for(std::size_t block = 0; block < blocks; ++block) {
          BOOST_CHECK_EQUAL(sums[block * size + i], sum);
          sum += counts[block * size + i];
        }
        BOOST_CHECK_EQUAL(totals[i], sum);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
