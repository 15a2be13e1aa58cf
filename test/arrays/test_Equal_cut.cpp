// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Equal cuts are monotone and leave nothing out, whatever the interval; and are nearly equal,
// against rational numbers.

#include "support/exact_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>

BOOST_AUTO_TEST_SUITE(Equal_cut)

using namespace test_support;

// Ordinary, huge, tiny and denormal ones, some whose length overflows, one at 2^60 with few doubles
// in it; single points, infinite and empty ones, which cannot be cut.
std::vector<internal::Interval> intervals()
{
  return {{0, 1},           {-0.3, 0.1},   {-1e308, 0.7e308}, {0, 1e308},
          {1, 1 + 1e-15},   {0, 5e-324},   {-5e-324, 1e-320}, {2e-308, 2.3e-308},
          {0x1p60, 0x1p60 + 4096}, {1, 1}, {-1e308, 1e308},   {-infinity, infinity},
          {-1.7e308, 1.7e308}, {1e-310, 2e-310}, {-3e-306, 1e-306}, internal::Interval()};
}

// In ascending order: the ends, their neighbors, and numbers inside and outside.
std::vector<double> numbers_around(const internal::Interval& interval)
{
  std::vector<double> numbers = {-infinity, -1e308, -1, 0, 1e-320, 1, 1e308, infinity};
  for(const double end : {interval.low, interval.high})
    for(const double to : {-infinity, end, infinity})
      numbers.push_back(std::nextafter(end, to));
  Random random(1);
  if(interval.low < interval.high && std::isfinite(interval.half_length()))
    for(int i = 0; i < 500; ++i) {
      const double share = random.uniform();
      numbers.push_back(interval.low * (1 - share) + interval.high * share);
    }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

BOOST_AUTO_TEST_CASE(pieces_follow_each_other_and_cover_all)
{
  for(const internal::Interval& interval : intervals())
    for(const double count : {0., 0.5, 1., 1.9, 2., 2.9, 3., 17., 1000., 1e6, 4e9}) {
      const internal::Equal_cut cut(interval, count);
      internal::Place last = 0;
      for(const double x : numbers_around(interval)) {
        BOOST_CHECK_GE(cut(x), last);
        BOOST_CHECK_LT(cut(x), cut.count());
        last = cut(x);
      }
      BOOST_CHECK_EQUAL(cut(-infinity), 0u);
      BOOST_CHECK_EQUAL(cut(infinity), cut.count() - 1);
      BOOST_CHECK_EQUAL(cut(interval.low), 0u);
      if(interval.low <= interval.high)
        BOOST_CHECK_EQUAL(cut(interval.high), cut.count() - 1);
      BOOST_CHECK(cut.count() == 1 || cut.count() == std::floor(count));
    }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_computed_is_not_cut)
{
  for(const internal::Interval& interval :
      {internal::Interval{1, 1}, internal::Interval{-infinity, infinity}, internal::Interval()})
    BOOST_CHECK_EQUAL(internal::Equal_cut(interval, 1000).count(), 1u);
  BOOST_CHECK_EQUAL(internal::Equal_cut({0, 1}, std::nan("")).count(), 1u);
  BOOST_CHECK_EQUAL(internal::Equal_cut().count(), 1u);
  BOOST_CHECK_EQUAL(internal::Equal_cut({0, 1}, 1000).count(), 1000u);
}

// Off by one piece at most, from where a coordinate is in real numbers.
BOOST_AUTO_TEST_CASE(pieces_are_nearly_equal)
{
  for(const internal::Interval& interval :
      {internal::Interval{0, 1}, internal::Interval{-0.3, 0.1}, internal::Interval{-1e308, 0.7e308},
       internal::Interval{-1.7e308, 1.7e308}, internal::Interval{5e-324, 1e-310},
       internal::Interval{-1e-306, 1e-306}})
    for(const int count : {2, 17, 1000}) {
      const internal::Equal_cut cut(interval, count);
      const Rational low(interval.low), length = Rational(interval.high) - low;
      BOOST_CHECK_EQUAL(cut.count(), static_cast<internal::Place>(count));
      for(const double x : numbers_around(interval))
        if(x >= interval.low && x <= interval.high) {
          const Rational piece = (Rational(x) - low) / length * count;
          BOOST_CHECK(abs(Rational(piece - Rational(1) / 2 - Rational(cut(x)))) <= 1);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
