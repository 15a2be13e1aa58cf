// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The grid of doubles, and steps of it modulo 2^64, against rational numbers.

#include "support/exact_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>

BOOST_AUTO_TEST_SUITE(Double_grid)

using namespace test_support;

// x / 2^e.
Rational steps_of(double x, int e)
{
  const Integer power = Integer(1) << std::abs(e);
  return e < 0 ? Rational(Rational(x) * power) : Rational(Rational(x) / power);
}

bool is_on_grid(double x, int e) { return denominator(steps_of(x, e)) == 1; }

// A double of up to `bits` bits, of any sign and magnitude.
double random_double(Random& random, int bits)
{
  const int exponent = static_cast<int>(random.below(2098 - 53)) - 1074;
  const double x = std::ldexp(random.fixed_point(bits), bits + exponent);
  return random.below(2) == 0 ? x : -x;
}

BOOST_AUTO_TEST_CASE(the_grid_is_the_coarsest_that_holds_all_numbers)
{
  Random random(1);
  for(int repetition = 0; repetition < 3000; ++repetition) {
    internal::Double_grid grid;
    std::vector<double> numbers;
    for(std::size_t count = 1 + random.below(4); count > 0; --count) {
      numbers.push_back(random_double(random, 1 + static_cast<int>(random.below(53))));
      grid.add(numbers.back());
    }
    bool holds_all = true, is_any_odd = false;
    for(const double x : numbers) {
      holds_all = holds_all && is_on_grid(x, grid.exponent());
      is_any_odd = is_any_odd || !is_on_grid(x, grid.exponent() + 1);
    }
    BOOST_CHECK(holds_all);
    BOOST_CHECK(is_any_odd || numbers == std::vector<double>(numbers.size(), 0));
  }
}

BOOST_AUTO_TEST_CASE(zeros_have_any_grid)
{
  internal::Double_grid grid, other;
  grid.add(0);
  grid.add(-0.);
  BOOST_CHECK_EQUAL(grid.exponent(), 0);
  other.add(8);
  grid.add(other);
  BOOST_CHECK_EQUAL(grid.exponent(), 3);
  grid.add(-5e-324);
  BOOST_CHECK_EQUAL(grid.exponent(), -1074);
  other.add((std::numeric_limits<double>::max)());
  BOOST_CHECK_EQUAL(other.exponent(), 3);
}

BOOST_AUTO_TEST_CASE(a_grid_holds_multiples_of_its_step)
{
  const internal::Double_grid grid(-3);
  BOOST_CHECK_EQUAL(grid.exponent(), -3);
  for(const double x : {0., -0., 0.125, -7.875, 0x1p-3 + 0x1p40, 0x1p100})
    BOOST_CHECK(grid.holds(x));
  for(const double x : {0.0625, -7.9375, 0x1p-4 + 0x1p40, 5e-324, 0.1})
    BOOST_CHECK(!grid.holds(x));
}

// Of numbers on the grid, and of others without what is below it; however large they are.
BOOST_AUTO_TEST_CASE(steps_are_counted_modulo_2_to_64)
{
  const Integer modulus = Integer(1) << 64;
  Random random(2);
  for(int repetition = 0; repetition < 20000; ++repetition) {
    const double x = random_double(random, 53);
    int exponent;
    std::frexp(x, &exponent);
    const int e = exponent - 150 + static_cast<int>(random.below(200)); // bits to all sides of x
    const Rational steps = steps_of(std::fabs(x), e);
    Integer expected = Integer(numerator(steps) / denominator(steps)) % modulus;
    if(x < 0 && expected != 0)
      expected = modulus - expected;
    BOOST_CHECK_EQUAL(Integer(internal::steps_modulo_2_64(x, e)), expected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
