// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lists made from pairs in any order, against a plain sort of the pairs.

#include "support/counting_allocator.h"
#include "support/pairs.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>

BOOST_AUTO_TEST_SUITE(Neighbor_collector)

using namespace test_support;

// Distinct pairs; every tenth one has the first point, which so gets a long list.
Pairs random_pairs(std::size_t size, std::size_t count, Random& random)
{
  std::set<Pair> pairs;
  while(pairs.size() < count) {
    const std::size_t i = random.below(10) == 0 ? 0 : random.below(size);
    const std::size_t j = random.below(size);
    if(i != j)
      pairs.insert(std::minmax(i, j));
  }
  return shuffled(Pairs(pairs.begin(), pairs.end()), random);
}

void check_lists(std::size_t size, std::size_t count)
{
  Random random(size);
  internal::Neighbor_collector collect(size, internal::Threads());
  const Pairs pairs = random_pairs(size, count, random);
  for(const Pair& p : pairs)
    collect(p.first, p.second);
  const CGAL::Neighbor_lists lists = collect.lists();
  BOOST_CHECK_EQUAL(lists.size(), size);
  BOOST_CHECK_EQUAL(lists.number_of_pairs(), count);
  BOOST_CHECK(pairs_in_lists(lists) == in_both_orders(pairs));
}

// Points fill no bin, one bin, two bins, and some of a third one; or have positions of 17 bits.
BOOST_AUTO_TEST_CASE(lists_are_the_sorted_pairs)
{
  constexpr std::size_t bin_size = internal::Neighbor_bins::bin_size;
  check_lists(0, 0);
  check_lists(1, 0);
  check_lists(2, 1);
  check_lists(1000, 20000);
  check_lists(bin_size, 1000);
  check_lists(bin_size + 1, 1000);
  check_lists(2 * bin_size, 1000);
  check_lists(5 * bin_size / 2, 50000);
  check_lists(100000, 50000);
}

BOOST_AUTO_TEST_CASE(lists_in_any_order_are_put_in_the_order_of_points)
{
  const std::size_t size = 20000;
  Random random(7);
  internal::Neighbor_collector collect_pairs(size, internal::Threads());
  for(const Pair& p : random_pairs(size, 50000, random))
    collect_pairs(p.first, p.second);
  const CGAL::Neighbor_lists expected = collect_pairs.lists();

  internal::Neighbor_collector collect_lists(size, internal::Threads());
  for(std::size_t i = 0; i < size; ++i) { // 7919 is prime
    const std::size_t of = i * 7919 % size;
    collect_lists.local_lists().append(static_cast<CGAL::Neighbor_lists::Position>(of),
                                       expected[of].begin(), expected[of].end());
  }
  BOOST_CHECK(collect_lists.lists() == expected);
}

BOOST_AUTO_TEST_CASE(bins_that_are_cleared_take_no_memory_of_neighbors)
{
  using Bins = internal::Neighbor_bins;
  const std::size_t before = current_bytes();
  Bins bins(Bins::bin_size);
  for(Bins::Position i = 0; i < 10000; ++i)
    bins.add(i, i);
  BOOST_CHECK_GT(current_bytes() - before, 50000u);
  bins.clear();
  BOOST_CHECK_LT(current_bytes() - before, 1000u);
}

BOOST_AUTO_TEST_CASE(pairs_in_one_of_their_lists_are_left_out_of_mutual_neighbors)
{
  const CGAL::Neighbor_lists lists({0, 3, 4, 5, 7}, {1, 2, 3, 0, 3, 0, 1});
  const CGAL::Neighbor_lists mutual({0, 2, 3, 3, 4}, {1, 3, 0, 0});
  BOOST_CHECK(internal::mutual_neighbors(lists) == mutual);
  BOOST_CHECK(internal::mutual_neighbors(mutual) == mutual);
}

BOOST_AUTO_TEST_SUITE_END()
