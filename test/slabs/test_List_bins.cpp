// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Short lists, and the memory of bins. That bins have the lists of their points is left to
// test_Neighbor_collector.cpp.

#include "support/counting_allocator.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/slabs/List_bins.h>

BOOST_AUTO_TEST_SUITE(List_bins)

using namespace test_support;
using internal::Place;
using Bins = internal::List_bins;

BOOST_AUTO_TEST_CASE(short_lists_have_room_for_more)
{
  Bins bins(1);
  std::vector<Place> expected;
  for(Place i = 0; i < 10000; ++i) {
    Place* const list = bins.append_short(0, i % 3);
    std::fill_n(list, Bins::max_short_size, i);
    expected.insert(expected.end(), i % 3, i);
  }
  std::vector<Place> found;
  bins.for_each(0, [&](std::size_t, const Place* first, const Place* last) {
    found.insert(found.end(), first, last);
  });
  BOOST_CHECK(found == expected);
}

// One of many threads has few lists in each bin.
BOOST_AUTO_TEST_CASE(bins_of_few_lists_take_little_memory)
{
  const std::size_t bin_count = 128, before = current_bytes();
  Bins bins(bin_count * Bins::bin_size);
  for(std::size_t i = 0; i < 2 * bin_count; ++i)
    bins.append_short(static_cast<Place>(i * Bins::bin_size / 2), 10);
  BOOST_CHECK_LT(current_bytes() - before, 512 * bin_count);
}

BOOST_AUTO_TEST_CASE(bins_that_are_cleared_take_no_memory_of_lists)
{
  const std::size_t before = current_bytes();
  Bins bins(Bins::bin_size);
  for(Place i = 0; i < 10000; ++i)
    bins.append_short(i % Bins::bin_size, 10);
  BOOST_CHECK_GT(current_bytes() - before, 400000u);
  bins.clear();
  BOOST_CHECK_LT(current_bytes() - before, 1000u);
}

BOOST_AUTO_TEST_SUITE_END()
