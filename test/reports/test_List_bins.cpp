// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/counting_allocator.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/reports/List_bins.h>

BOOST_AUTO_TEST_SUITE(List_bins)

using namespace test_support;
using Bins = internal::List_bins;
using Neighbor = std::pair<std::size_t, Bins::Position>;

// Lists of 32 neighbors or fewer, and lists that fill several chunks.
std::size_t random_size(Random& random)
{
  return random.below(20) == 0 ? random.below(5000) : random.below(Bins::max_short_size + 1);
}

BOOST_AUTO_TEST_CASE(each_bin_has_the_lists_of_its_points)
{
  const std::size_t size = 3 * Bins::bin_size + 1; // the last bin has a single point
  Bins bins(size);
  std::vector<std::vector<Neighbor>> expected(4);
  Random random(1);
  for(int i = 0; i < 3000; ++i) {
    const auto of = static_cast<Bins::Position>(i % 10 == 0 ? size - 1 : random.below(size));
    std::vector<Bins::Position> list(random_size(random));
    for(Bins::Position& neighbor : list) {
      neighbor = static_cast<Bins::Position>(random.below(0xffffffff)); // all 32 bits
      expected[of / Bins::bin_size].emplace_back(of % Bins::bin_size, neighbor);
    }
    if(list.size() > Bins::max_short_size || i % 2 == 0)
      bins.append(of, list.data(), list.data() + list.size());
    else
      std::copy(list.begin(), list.end(), bins.append_short(of, list.size()));
  }
  for(std::size_t bin = 0; bin < 4; ++bin) {
    std::vector<Neighbor> found;
    bins.for_each(bin, [&](std::size_t of, const Bins::Position* first,
                           const Bins::Position* last) {
      for(; first != last; ++first)
        found.emplace_back(of, *first);
    });
    BOOST_CHECK(found == expected[bin]);
    BOOST_CHECK_EQUAL(bins.size(bin), expected[bin].size());
  }
}

BOOST_AUTO_TEST_CASE(short_lists_have_room_for_more)
{
  Bins bins(1);
  std::vector<Bins::Position> expected;
  for(Bins::Position i = 0; i < 10000; ++i) {
    Bins::Position* const list = bins.append_short(0, i % 3);
    std::fill_n(list, Bins::max_short_size, i);
    expected.insert(expected.end(), i % 3, i);
  }
  std::vector<Bins::Position> found;
  bins.for_each(0, [&](std::size_t, const Bins::Position* first, const Bins::Position* last) {
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
    bins.append_short(static_cast<Bins::Position>(i * Bins::bin_size / 2), 10);
  BOOST_CHECK_LT(current_bytes() - before, 512 * bin_count);
}

BOOST_AUTO_TEST_CASE(bins_that_are_cleared_take_no_memory_of_lists)
{
  const std::size_t before = current_bytes();
  Bins bins(Bins::bin_size);
  internal::Neighbor_bins neighbors(Bins::bin_size);
  for(Bins::Position i = 0; i < 10000; ++i) {
    bins.append_short(i % Bins::bin_size, 10);
    neighbors.add(i % Bins::bin_size, i);
  }
  BOOST_CHECK_GT(current_bytes() - before, 400000u);
  bins.clear();
  neighbors.clear();
  BOOST_CHECK_LT(current_bytes() - before, 1000u);
}

BOOST_AUTO_TEST_SUITE_END()
