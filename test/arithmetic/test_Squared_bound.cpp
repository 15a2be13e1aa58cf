// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The squared bound in doubles and in steps of a grid, against rational numbers.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>

BOOST_AUTO_TEST_SUITE(Squared_bound)

using namespace test_support;

// Bounds of every magnitude: the doubles around r^2, the reach, and the largest double within.
template <class Exact>
void check_doubles(double r, bool is_open, int mode)
{
  const auto closed = CGAL::within_distance(r);
  std::optional<Rounding_mode> in_mode(mode);
  const internal::Squared_bound<Exact> bound(is_open ? closed.open() : closed);
  const double threshold = bound.largest_double();
  in_mode.reset();
  const double next = std::nextafter(threshold, infinity);
  const Rational r2 = Rational(r) * Rational(r);
  const auto is_within = [&](const Rational& s) { return is_open ? s < r2 : s <= r2; };
  BOOST_CHECK(Rational(bound.squared().first) <= r2);
  BOOST_CHECK(bound.squared().second == infinity || r2 <= Rational(bound.squared().second));
  BOOST_CHECK_GE(bound.reach(), r);
  BOOST_CHECK(is_within(Rational(threshold)));
  BOOST_CHECK(next == infinity || !is_within(Rational(next)));
}

// Few of the squares are doubles.
BOOST_AUTO_TEST_CASE(doubles_enclose_the_bound_in_every_rounding_mode)
{
  Random random(1);
  for(const int mode : rounding_modes)
    for(const bool is_open : {false, true}) {
      std::vector<double> bounds = {0, 5};
      for(int exponent = -1070; exponent < 1023; exponent += 7)
        bounds.push_back(std::ldexp(1 + random.uniform(), exponent));
      for(const double r : bounds) {
        check_doubles<internal::Exact_number_t<double>>(r, is_open, mode);
        check_doubles<CGAL::Exact_rational>(r, is_open, mode);
      }
    }
}

// Half of the roots are rounded down.
BOOST_AUTO_TEST_CASE(the_reach_of_a_squared_bound_is_not_below_its_root)
{
  for(int square = 1; square < 100; ++square) {
    const internal::Squared_bound<CGAL::Exact_rational> bound(
      CGAL::within_squared_distance(square));
    BOOST_CHECK(Rational(bound.reach()) * Rational(bound.reach()) >= square);
    BOOST_CHECK_CLOSE(bound.reach(), std::sqrt(square), 1e-10);
  }
}

// r^2 is beyond the range of doubles, and r is not.
template <class Exact, class NT>
void check_tight_reach()
{
  for(const double r : {5e-324, 1e-321, 3e-310, 1e-200, 1e-80, 1e80, 1e200, 1.2e308}) {
    const NT root(r);
    const internal::Squared_bound<Exact> bound(CGAL::within_squared_distance(NT(root * root)));
    BOOST_CHECK_GE(bound.reach(), r);
    BOOST_CHECK_LE(bound.reach(), std::nextafter(std::nextafter(r * (1 + 1e-15), infinity),
                                                 infinity));
  }
}

BOOST_AUTO_TEST_CASE(the_reach_of_an_exact_squared_bound_is_tight_at_all_scales)
{
  using Exact = internal::Exact_number_t<double>;
  using Lazy = CGAL::Lazy_exact_nt<CGAL::Exact_rational>;
  check_tight_reach<Exact, Exact>();
  check_tight_reach<Exact, CGAL::Exact_rational>();
  check_tight_reach<CGAL::Exact_rational, CGAL::Exact_rational>();
  check_tight_reach<Lazy, Lazy>();
  check_tight_reach<CGAL::Exact_rational, Lazy>();
}

// floor(r^2 / 4^e) + 1, or r^2 / 4^e itself if that is an integer and the bound is open.
Integer first_beyond(const Rational& r2, int e, bool is_open)
{
  const Integer power = Integer(1) << 2 * std::abs(e);
  const Rational steps = e < 0 ? Rational(r2 * power) : Rational(r2 / power);
  const Integer quotient = numerator(steps) / denominator(steps);
  return is_open && denominator(steps) == 1 ? quotient : Integer(quotient + 1);
}

// With r^2 = n 4^e / d.
template <class Exact>
void check_first_beyond(std::uint64_t n, std::uint64_t d, int e)
{
  const auto exact = [](double x) { return CGAL::Exact_rational(x); };
  const auto number = [&](std::uint64_t i) {
    return CGAL::Exact_rational(exact(static_cast<double>(i >> 32)) * exact(0x1p32)
                                + exact(static_cast<double>(i & 0xffffffff)));
  };
  const CGAL::Exact_rational unit = exact(std::ldexp(1., e));
  const auto closed
    = CGAL::within_squared_distance(CGAL::Exact_rational(number(n) / number(d) * unit * unit));
  const Rational r2 = Rational(Integer(n)) / Rational(Integer(d));
  for(const bool is_open : {false, true}) {
    const internal::Squared_bound<Exact> bound(is_open ? closed.open() : closed);
    for(const int finer : {0, 31}) {
      const internal::Uint128 beyond = bound.first_beyond(e - finer);
      const Integer found = (Integer(static_cast<std::uint64_t>(beyond >> 64)) << 64)
                            + static_cast<std::uint64_t>(beyond);
      BOOST_CHECK_EQUAL(found, first_beyond(r2, -finer, is_open));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_first_square_beyond_is_that_of_rational_numbers)
{
  Random random(2);
  for(const int e : {0, 1, -20, 300, -500})
    for(int i = 0; i < 100; ++i) {
      const std::uint64_t n = random.below(std::uint64_t(1) << (1 + random.below(62)));
      const std::uint64_t d = i % 2 == 0 ? 1 : 1 + random.below(1000);
      check_first_beyond<internal::Exact_number_t<double>>(n, d, e);
      check_first_beyond<CGAL::Exact_rational>(n, d, e);
    }
}

// The interval of a lazy number is wide after a cancellation.
BOOST_AUTO_TEST_CASE(doubles_are_close_to_a_lazy_bound)
{
  using Lazy = CGAL::Lazy_exact_nt<CGAL::Exact_rational>;
  const Lazy large(1e16), r(Lazy(large + Lazy(8.5)) - large);
  BOOST_REQUIRE(CGAL::to_interval(r) != std::make_pair(8.5, 8.5));
  const internal::Squared_bound<Lazy> bound(CGAL::within_distance(r));
  BOOST_CHECK_LT(bound.squared().second - bound.squared().first, 1e-10);
  BOOST_CHECK_EQUAL(bound.reach(), 8.5);
}

BOOST_AUTO_TEST_SUITE_END()
