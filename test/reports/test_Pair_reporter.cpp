// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A reporter hands pairs on until the callback, or the search, says stop.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

BOOST_AUTO_TEST_SUITE(Pair_reporter)

using namespace test_support;

static_assert(!internal::One_set::are_two && internal::Two_sets::are_two);

BOOST_AUTO_TEST_CASE(a_callback_that_returns_nothing_never_stops)
{
  std::size_t sum = 0;
  auto add = [&](std::size_t i, std::size_t j) { sum += 10 * i + j; };
  internal::Pair_reporter<decltype(add)> report(add);
  BOOST_CHECK(report(1, 2));
  BOOST_CHECK(report(3, 4));
  BOOST_CHECK_EQUAL(sum, 46u);
  BOOST_CHECK(!report.is_stopped());
  report.stop();
  BOOST_CHECK(report.is_stopped());
}

BOOST_AUTO_TEST_CASE(a_callback_stops_by_returning_false)
{
  auto is_small = [](std::size_t i, std::size_t) { return i < 2; };
  internal::Pair_reporter<decltype(is_small)> report(is_small);
  BOOST_CHECK(report(1, 2));
  BOOST_CHECK(!report.is_stopped());
  BOOST_CHECK(!report(2, 3));
  BOOST_CHECK(report.is_stopped());
}

BOOST_AUTO_TEST_CASE(a_callback_that_throws_stops_the_other_threads)
{
  auto fail = [](std::size_t, std::size_t) { throw 7; };
  internal::Pair_reporter<decltype(fail)> report(fail);
  BOOST_CHECK_THROW(report(1, 2), int);
  BOOST_CHECK(report.is_stopped());
}

BOOST_AUTO_TEST_SUITE_END()
