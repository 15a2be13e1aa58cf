// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The grid of doubles, and steps of it, against rational numbers, up to the ends of the range of
// doubles: those of a number modulo 2^64, and those of a few numbers in every rounding mode.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
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

// ---- the steps of a few numbers -----------------------------------------------------------------

using Numbers = std::array<double, 4>;

Rational between(double x, double y) { return Rational(y) - Rational(x); }

// Whether the steps are those of the numbers, up to one factor, with no common factor of two, and
// the bits are as few as they can be, but for one.
bool are_right(const Numbers& x, const std::array<std::int64_t, 4>& steps, int bits)
{
  bool are_proportional = true, is_any_odd = false;
  std::int64_t largest = 0;
  for(std::size_t i = 0; i < x.size(); ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const std::int64_t step = steps[i] - steps[j];
      largest = (std::max)(largest, step < 0 ? -step : step);
      is_any_odd |= step % 2 != 0;
      are_proportional
        &= between(x[j], x[i]) * Rational(double(steps[1] - steps[0]))
           == between(x[0], x[1]) * Rational(double(step));
    }
  const double size = static_cast<double>(largest);
  return are_proportional && (is_any_odd || largest == 0) && size <= std::ldexp(1., bits)
         && (bits < 2 || size > std::ldexp(1., bits - 2));
}

// Small numbers of steps, so that doubles hold their products, at any scale and offset.
Numbers numbers_on_grid(Random& random, int exponent, double offset)
{
  Numbers x;
  for(double& value : x)
    value = std::ldexp(offset + static_cast<double>(random.below(1000)), exponent);
  return x;
}

BOOST_AUTO_TEST_CASE(steps_are_those_of_the_numbers)
{
  Random random(1);
  std::size_t wrong = 0;
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    for(int i = 0; i < 5000; ++i)
      for(const int exponent : {-1074, -1060, -970, -500, -30, 0, 300, 970}) {
        const double offsets[] = {0, 1, -500, 0x1p40, -0x1p52};
        const Numbers x = numbers_on_grid(random, exponent, offsets[random.below(5)]);
        std::array<std::int64_t, 4> steps;
        const int bits = internal::grid_steps(x, steps);
        wrong += !are_right(x, steps, bits);
      }
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

BOOST_AUTO_TEST_CASE(equal_numbers_take_no_bits)
{
  for(const double x : {0., -0., 1., -0.1, 0x1p-1074, 0x1p1023}) {
    std::array<std::int64_t, 4> steps = {1, 2, 3, 4};
    BOOST_CHECK_EQUAL(internal::grid_steps(Numbers{x, x, x, x}, steps), 0);
    BOOST_CHECK(steps == (std::array<std::int64_t, 4>{}));
  }
}

BOOST_AUTO_TEST_CASE(differences_beyond_the_doubles_are_found_in_every_rounding_mode)
{
  const double greatest = (std::numeric_limits<double>::max)();
  for(const int mode : rounding_modes) {
    const Rounding_mode rounding(mode);
    std::array<std::int64_t, 2> steps;
    const int bits = internal::grid_steps(std::array<double, 2>{-greatest, greatest}, steps);
    BOOST_CHECK_EQUAL(steps[1] - steps[0], (std::int64_t(1) << 53) - 1);
    BOOST_CHECK_EQUAL(bits, 53);
  }
}

BOOST_AUTO_TEST_CASE(numbers_of_many_bits_do_not_fit)
{
  std::array<std::int64_t, 2> steps;
  for(int bits = 30; bits < 120; ++bits) {
    const double large = std::ldexp(1., bits);
    const bool fits = internal::grid_steps(std::array<double, 2>{1, large}, steps)
                      <= internal::max_step_bits;
    BOOST_CHECK_EQUAL(fits, bits <= 59);
    if(fits)
      BOOST_CHECK_EQUAL(steps[1] - steps[0], (std::int64_t(1) << bits) - 1);
    std::array<std::int64_t, 3> more_steps;
    const std::array<double, 3> more = {0x1p-1074, large, -0x1p-1074};
    BOOST_CHECK_GT(internal::grid_steps(more, more_steps), internal::max_step_bits);
  }
}

BOOST_AUTO_TEST_SUITE_END()
