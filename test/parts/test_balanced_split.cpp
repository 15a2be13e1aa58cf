// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How a sequence of points is divided into two groups.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/parts/balanced_split.h>

BOOST_AUTO_TEST_SUITE(balanced_split)

using namespace test_support;

// The sums of loads that are the same at each place, with all pairs in [begin, end) of 100 places.
std::vector<internal::Point_load> sums_of(std::size_t begin, std::size_t end, double pairs = 1)
{
  std::vector<internal::Point_load> sums(1);
  for(std::size_t i = 0; i < 100; ++i) {
    const double added = begin <= i && i < end ? pairs / static_cast<double>(end - begin) : 0;
    sums.push_back({sums.back().points + 0.01, sums.back().pairs + added});
  }
  return sums;
}

BOOST_AUTO_TEST_CASE(one_cut_divides_even_loads)
{
  for(const double share : {0.5, 0.25, 0.6}) {
    const internal::Split split = internal::Split_finder(sums_of(0, 100), share)();
    BOOST_CHECK_EQUAL(split.begin, 0);
    BOOST_CHECK_EQUAL(split.end, static_cast<std::size_t>(100 * share + 0.5));
    BOOST_CHECK_SMALL(split.error, 1e-9);
  }
}

// The crowd is at the beginning, in the middle or at the end.
BOOST_AUTO_TEST_CASE(two_cuts_divide_points_and_a_crowd)
{
  for(const std::size_t crowd : {0, 33, 80})
    for(const double share : {0.5, 0.25, 0.8}) {
      const auto sums = sums_of(crowd, crowd + 20);
      const internal::Split split = internal::Split_finder(sums, share)();
      const bool is_inside = split.begin <= split.end;
      const double points = sums[split.end].points - sums[split.begin].points + !is_inside;
      const double pairs = sums[split.end].pairs - sums[split.begin].pairs + !is_inside;
      BOOST_CHECK_SMALL(points - share, 1e-9);
      BOOST_CHECK_SMALL(pairs - share, 1e-9);
      BOOST_CHECK_SMALL(split.error, 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(points_are_divided_without_pairs)
{
  const internal::Split split = internal::Split_finder(sums_of(0, 20, 0), 0.3)();
  BOOST_CHECK_EQUAL(split.begin, 0);
  BOOST_CHECK_EQUAL(split.end, 30);
}

// One place has all the pairs, so one group has them.
BOOST_AUTO_TEST_CASE(points_count_more_than_pairs)
{
  const internal::Split split = internal::Split_finder(sums_of(10, 11), 0.5)();
  const bool is_inside = split.begin <= split.end;
  BOOST_CHECK_EQUAL(is_inside ? split.end - split.begin : split.begin - split.end, 50);
  BOOST_CHECK_CLOSE(split.error, 1, 1e-6);
}

BOOST_AUTO_TEST_CASE(no_points_are_not_divided)
{
  const internal::Split split = internal::Split_finder({{0, 0}}, 0.5)();
  BOOST_CHECK_EQUAL(split.begin, 0);
  BOOST_CHECK_EQUAL(split.end, 0);
}

BOOST_AUTO_TEST_SUITE_END()
