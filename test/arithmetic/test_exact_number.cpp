// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers of many types in one exact type.

#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/MP_Float.h>
#ifdef CGAL_USE_GMP
#include <CGAL/Gmpfr.h>
#include <CGAL/Gmpzf.h>
#endif
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/cpp_int.hpp>

BOOST_AUTO_TEST_SUITE(exact_number)

using namespace test_support;
BOOST_AUTO_TEST_CASE(numbers_are_converted_without_rounding)
{
  using internal::to_exact_rational;
  using Exact = CGAL::Exact_rational;
  const auto power_of_two = [](int e) { return Exact(std::ldexp(1., e)); };
  BOOST_CHECK(to_exact_rational(0.1) == Exact(0.1));
  BOOST_CHECK(to_exact_rational(0.1f) == Exact(double(0.1f)));
  BOOST_CHECK(to_exact_rational((std::numeric_limits<long>::min)()) == -power_of_two(63));
  BOOST_CHECK(to_exact_rational((std::numeric_limits<unsigned long>::max)())
              == power_of_two(64) - 1);
  BOOST_CHECK(to_exact_rational(-7l) == -7);
  const long double third = 1.l / 3;
  const double head = static_cast<double>(third);
  BOOST_CHECK(to_exact_rational(third)
              == Exact(head) + Exact(static_cast<double>(third - static_cast<long double>(head))));
  const Exact large = power_of_two(1000) * power_of_two(1000) * power_of_two(1001);
  BOOST_CHECK(internal::rational_power_of_two(3001) == large);
  BOOST_CHECK(internal::rational_power_of_two(-3001) * large == 1);
  BOOST_CHECK(to_exact_rational(CGAL::Quotient<int>(1, 3)) == Exact(1) / 3);
}

// Their texts are those of doubles.
template <class NT>
void check_dyadic(const char* type)
{
  using internal::rational_power_of_two;
  BOOST_TEST_CONTEXT(type)
  for(const int mode : rounding_modes)
    for(const double factor : {1., 0x1p-300, 0x1p-700, 0x1p700}) {
      NT number(3), power(1);
      for(int i = 0; i < 3; ++i)
        power = power * NT(factor);
      number = (number + NT(0x1p-70)) * power;
      std::optional<Rounding_mode> in_mode(mode);
      const CGAL::Exact_rational value = internal::to_exact_rational(number);
      in_mode.reset();
      BOOST_CHECK(value == (3 + CGAL::Exact_rational(0x1p-70))
                             * rational_power_of_two(3 * std::ilogb(factor)));
      BOOST_CHECK(internal::to_exact_rational(NT(-number)) == -value);
    }
  BOOST_CHECK(internal::to_exact_rational(NT(0)) == 0);
}

BOOST_AUTO_TEST_CASE(integers_times_powers_of_two_are_converted_without_rounding)
{
  check_dyadic<CGAL::MP_Float>("MP_Float");
#ifdef CGAL_HAS_MPZF
  check_dyadic<CGAL::Mpzf>("Mpzf");
#endif
#ifdef CGAL_USE_GMP
  check_dyadic<CGAL::Gmpzf>("Gmpzf");
  const auto precision = CGAL::Gmpfr::set_default_precision(100);
  check_dyadic<CGAL::Gmpfr>("Gmpfr");
  CGAL::Gmpfr::set_default_precision(precision);
#endif
  const CGAL::Quotient<CGAL::MP_Float> third(CGAL::MP_Float(1) + CGAL::MP_Float(0x1p-70), 3);
  BOOST_CHECK(internal::to_exact_rational(third) * 3 == 1 + CGAL::Exact_rational(0x1p-70));
}

#ifdef __SIZEOF_INT128__
// They are built in for compilers with extensions of their own.
BOOST_AUTO_TEST_CASE(integers_of_128_bits_are_converted_without_rounding)
{
  using internal::rational_of_integer;
  __extension__ typedef __int128 Int;
  __extension__ typedef unsigned __int128 Unsigned;
  const Int square = (Int(1) << 100) + (Int(1) << 32) + 1;
  const CGAL::Exact_rational expected
    = CGAL::Exact_rational(0x1p100) + CGAL::Exact_rational(0x1p32) + 1;
  BOOST_CHECK(rational_of_integer(square) == expected);
  BOOST_CHECK(rational_of_integer(-square) == -expected);
  BOOST_CHECK(rational_of_integer(~Unsigned(0))
              == CGAL::Exact_rational(0x1p100) * CGAL::Exact_rational(0x1p28) - 1);
}
#endif

// A bound of 1.5 is to be held as well.
BOOST_AUTO_TEST_CASE(exact_numbers_hold_doubles)
{
  using namespace CGAL::Thick_intersection_d::internal;
  static_assert(std::is_same_v<Exact_number_t<CGAL::Exact_integer>, CGAL::Exact_rational>);
  static_assert(std::is_same_v<Exact_number_t<CGAL::Exact_rational>, CGAL::Exact_rational>);
  BOOST_CHECK(Exact_number_t<double>(1.5) * Exact_number_t<double>(2) == Exact_number_t<double>(3));
  BOOST_CHECK(Exact_number_t<CGAL::Exact_integer>(1.5) * 2 == 3);
}

// CGAL has no interval of some types, and one around zero for others.
BOOST_AUTO_TEST_CASE(integers_of_64_bits_have_bounds)
{
  const auto check = [](auto x, bool is_double) {
    const std::pair<double, double> bounds = internal::bounds(x);
    BOOST_CHECK(CGAL::Exact_rational(bounds.first) <= internal::to_exact_rational(x));
    BOOST_CHECK(CGAL::Exact_rational(bounds.second) >= internal::to_exact_rational(x));
    BOOST_CHECK_EQUAL(bounds.first == bounds.second, is_double);
  };
  check(0l, true);
  check(0ul, true);
  check((1ll << 53) - 1, true);
  check((1ll << 53) + 1, false);
  check(-(1ll << 53) - 1, false);
  check((std::numeric_limits<unsigned long>::max)(), false);
  static_assert(std::is_same_v<internal::Exact_number_t<unsigned>, CGAL::Exact_rational>);
}

// CGAL's interval of a long double is never a number, and has to be finite.
BOOST_AUTO_TEST_CASE(long_doubles_have_bounds)
{
  using namespace CGAL::Thick_intersection_d::internal;
  using Bounds = std::pair<double, double>;
  const double largest = (std::numeric_limits<double>::max)();
  BOOST_CHECK(bounds(.5l) == Bounds(.5, .5));
  BOOST_CHECK(bounds(-0x1p-1074l) == Bounds(-0x1p-1074, -0x1p-1074));
  const std::pair<double, double> third = bounds(1.l / 3);
  BOOST_CHECK(third.first <= 1.l / 3 && third.second >= 1.l / 3);
  if(std::numeric_limits<long double>::max_exponent > 1024) {
    BOOST_CHECK(bounds(std::ldexp(1.l, 1030)) == Bounds(largest, infinity));
    BOOST_CHECK(bounds(-std::ldexp(1.l, 1030)) == Bounds(-infinity, -largest));
  }
  BOOST_CHECK(!is_finite_number(static_cast<long double>(infinity)));
  BOOST_CHECK(!is_finite_number(static_cast<long double>(NAN)));
}

// CGAL's interval of a tiny Mpzf is far from it if rounding goes up.
BOOST_AUTO_TEST_CASE(bounds_of_tiny_numbers_are_close_in_every_rounding_mode)
{
  using namespace CGAL::Thick_intersection_d::internal;
  using Exact = Exact_number_t<double>;
  const double step = 0x1p-1074;
  for(const double x : {step, 0x1.234p-1030, -0x1.23456789p-1025, 0x1p-1022, 0.})
    for(const double steps : {0., 0.375}) // the second number is no double
      for(const int mode : rounding_modes) {
        const Exact number = Exact(x) + Exact(x) + Exact(steps) * Exact(step);
        std::optional<Rounding_mode> in_mode(mode);
        const std::pair<double, double> enclosing = bounds(number);
        in_mode.reset();
        BOOST_CHECK(Exact(enclosing.first) <= number);
        BOOST_CHECK(Exact(enclosing.second) >= number);
        BOOST_CHECK_LE(enclosing.second - enclosing.first, 4 * step);
      }
}

template <class NT>
void check_bounds(const NT& number)
{
  const CGAL::Exact_rational value = internal::to_exact_rational(number);
  for(const int mode : rounding_modes) {
    std::optional<Rounding_mode> in_mode(mode);
    const std::pair<double, double> enclosing = internal::bounds(number);
    in_mode.reset();
    BOOST_CHECK(std::isinf(enclosing.first) || enclosing.first <= value);
    BOOST_CHECK(std::isinf(enclosing.second) || enclosing.second >= value);
    BOOST_CHECK(internal::are_bounds_of_finite(enclosing));
  }
}

template <class NT>
void check_bounds_of_all_sizes()
{
  for(const double factor : {1., 0x1p-358, 0x1p-400, 0x1p300, 0x1.fp341, 0x1p500})
    for(const NT& number : {NT(1) + NT(0x1p-70), NT(-7)})
      check_bounds(NT(number * NT(factor) * NT(factor) * NT(factor)));
  check_bounds(NT(NT(0x1p512) * NT(0x1p512))); // the first power of two beyond the doubles
}

BOOST_AUTO_TEST_CASE(bounds_enclose_numbers_of_all_sizes_in_every_rounding_mode)
{
  using Rational = boost::multiprecision::cpp_rational;
  check_bounds_of_all_sizes<Rational>();
  check_bounds(Rational(Rational((std::numeric_limits<double>::max)()) + 1));
  check_bounds_of_all_sizes<CGAL::MP_Float>();
  check_bounds_of_all_sizes<CGAL::Quotient<CGAL::MP_Float>>();
#ifdef CGAL_HAS_MPZF
  check_bounds_of_all_sizes<CGAL::Mpzf>();
#endif
#ifdef CGAL_USE_GMP
  check_bounds_of_all_sizes<CGAL::Gmpzf>();
#endif
}

BOOST_AUTO_TEST_SUITE_END()
