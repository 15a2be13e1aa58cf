// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Intervals that are longer by a reach, in every rounding mode, against sums of rational numbers.

#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>

#include <boost/multiprecision/gmp.hpp>

BOOST_AUTO_TEST_SUITE(Interval)

using namespace test_support;
using Rational = boost::multiprecision::mpq_rational;

// Numbers of all sizes. Many are powers of two, next to which the steps of doubles change.
double any_number(Random& random)
{
  const int exponent = static_cast<int>(random.below(2090)) - 1074;
  const double x = std::ldexp(1 + static_cast<double>(random.below(4)) * 0x1p-52, exponent);
  const double y = std::ldexp(1 + static_cast<double>(random.below(1u << 31)) * 0x1p-31, exponent);
  return random.below(2) == 0 ? x : y;
}

BOOST_AUTO_TEST_CASE(longer_intervals_hold_the_sum_in_every_rounding_mode)
{
  Random random(1);
  for(int i = 0; i < 20000; ++i) {
    const double x = any_number(random) * (random.below(2) == 0 ? 1 : -1);
    const int shift = static_cast<int>(random.below(120)) - 60;
    const double near_x = std::ldexp(std::fabs(x), random.below(2) == 0 ? 0 : shift);
    const double reach = random.below(3) == 0 ? any_number(random) : near_x;
    if(!std::isfinite(reach))
      continue;
    const Rational sum = Rational(x) + Rational(reach);
    for(const int mode : rounding_modes) {
      internal::Interval interval;
      {
        const Rounding_mode rounding(mode);
        interval = internal::longer({-1, x}, reach);
      }
      BOOST_REQUIRE_EQUAL(interval.low, -1);
      const double high = interval.high;
      BOOST_REQUIRE(!std::isfinite(high) ? high > 0 : Rational(high) >= sum);
      const double steps = std::fabs(x + reach) * 0x1p-49 + 0x1p-1070;
      BOOST_REQUIRE(!std::isfinite(high + steps) || Rational(high) <= sum + Rational(steps));
    }
  }
}

BOOST_AUTO_TEST_CASE(doubles_before_and_after_are_those_of_the_library)
{
  Random random(2);
  std::vector<double> numbers = {0., -0., 0x1p-1074, 1, 0x1.fffffffffffffp1023, infinity};
  for(int i = 0; i < 1000; ++i)
    numbers.push_back(any_number(random));
  for(const double number : numbers)
    for(const double x : {number, -number}) {
      BOOST_REQUIRE_EQUAL(internal::double_before(x), std::nextafter(x, -infinity));
      BOOST_REQUIRE_EQUAL(internal::double_after(x), std::nextafter(x, infinity));
    }
  BOOST_CHECK(std::isnan(internal::double_before(std::nan(""))));
}

BOOST_AUTO_TEST_CASE(infinite_reach)
{
  BOOST_CHECK_EQUAL(internal::longer({-1, 1}, infinity).high, infinity);
}

BOOST_AUTO_TEST_SUITE_END()
