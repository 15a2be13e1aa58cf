// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distances in integers of 64 and 128 bits against integers of any length: near ties up to the
// limits of each, far from the origin, on the grid and off it, in every rounding mode.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
#include "support/squared_distance.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>

BOOST_AUTO_TEST_SUITE(Integer_distance)

using namespace test_support;
using CGAL::Arithmetic_tier;

using Bound = internal::Squared_bound<internal::Exact_number_t<double>>;

// Coordinates in steps of the grid: integers, as doubles.
struct Pair_of_points
{
  Coordinates p, q;
};

// The integer root of what is left of U^2, moved by -1, 0 or 1, and rounded to a double.
double near_root(const Integer& rest, Random& random)
{
  const Integer root = sqrt(rest);
  return static_cast<double>(root) + static_cast<double>(random.below(3)) - 1;
}

// Points at about U steps of each other, one of them anywhere up to 2^60 steps from the origin.
Pair_of_points near_tie(int dimension, double units, Random& random)
{
  Pair_of_points pair;
  Integer rest = Integer(units) * Integer(units);
  const double offset = std::ldexp(1., static_cast<int>(random.below(61)));
  for(int axis = 0; axis < dimension; ++axis) {
    double gap = 0;
    if(axis + 1 == dimension)
      gap = near_root(rest, random);
    else {
      gap = std::floor(static_cast<double>(Integer(sqrt(rest))) * 0.9 * random.uniform());
      rest -= Integer(gap) * Integer(gap);
    }
    pair.p.push_back(std::floor(offset * random.uniform()));
    pair.q.push_back(pair.p.back() + (random.below(2) == 0 ? gap : -gap));
  }
  return pair;
}

void check_pair(const Pair_of_points& pair, double units, int exponent, int mode,
                Arithmetic_tier tier)
{
  const Integer bound_square = Integer(units) * Integer(units);
  const int sign = squared_distance<Integer>(pair.p, pair.q).compare(bound_square);
  const auto x = [&](int i) { return std::ldexp(pair.p[static_cast<std::size_t>(i)], exponent); };
  const auto y = [&](int i) { return std::ldexp(pair.q[static_cast<std::size_t>(i)], exponent); };
  const auto bound = CGAL::within_distance(std::ldexp(units, exponent));
  const int dimension = static_cast<int>(pair.p.size());
  std::optional<bool> closed, open;
  {
    const Rounding_mode in_mode(mode);
    closed = internal::Integer_distance(Bound(bound), exponent, tier).decide(x, y, dimension);
    open = internal::Integer_distance(Bound(bound.open()), exponent, tier)
             .decide(x, y, dimension);
  }
  BOOST_TEST_CONTEXT(units << " steps of 2^" << exponent << ", rounding mode " << mode)
  {
    BOOST_CHECK(closed == (sign <= 0));
    BOOST_CHECK(open == (sign < 0));
  }
}

void check_near_ties(int dimension, double units, Arithmetic_tier tier)
{
  Random random(1);
  for(const int mode : rounding_modes)
    for(const int exponent : {0, -1074, -30, 900})
      for(int i = 0; i < 100; ++i)
        check_pair(near_tie(dimension, units, random), units, exponent, mode, tier);
}

BOOST_AUTO_TEST_CASE(near_ties_in_64_bits)
{
  for(const double units : {0., 1., 5., 67108865., 2147483647.})
    check_near_ties(2, units, Arithmetic_tier::INT64);
  check_near_ties(1, 3037000499., Arithmetic_tier::INT64);
  check_near_ties(3, 1753413056., Arithmetic_tier::INT64);
}

BOOST_AUTO_TEST_CASE(near_ties_in_128_bits)
{
  const double last_exact = 0x1p53;
  for(const double units : {5., 2147483648., last_exact - 1, last_exact, last_exact + 2, 1e18,
                            0x1p63 - 1024})
    for(const int dimension : {1, 2, 3, 4})
      check_near_ties(dimension, units, Arithmetic_tier::INT128);
}

// At the reach, and one step beyond it, along a single axis and far from the origin.
BOOST_AUTO_TEST_CASE(one_step_beyond_the_reach_is_beyond)
{
  for(const double units : {3., 1000000., 0x1p40})
    for(const double offset : {0., 0x1p20, -0x1p52, 0x1p52 - 7})
      for(const double step : {-1., 0., 1.})
        for(const int mode : rounding_modes) {
          const Pair_of_points pair = {{offset, 1}, {offset + units + step, 1}};
          check_pair(pair, units, -20, mode, Arithmetic_tier::INT128);
          if(units < 0x1p31)
            check_pair(pair, units, -20, mode, Arithmetic_tier::INT64);
        }
}

// Differences of 2^64 steps are zero modulo 2^64.
BOOST_AUTO_TEST_CASE(points_a_multiple_of_2_to_64_steps_apart_are_far)
{
  for(const double units : {0x1p53, 0x1p62})
    for(const double far : {0x1p64, -0x1p64, 0x1p70, 0x1p64 + 0x1p12})
      for(const int mode : rounding_modes)
        check_pair({{0, 0}, {far, 0}}, units, 0, mode, Arithmetic_tier::INT128);
}

// Differences that are longer than U steps and round to U: five of their squares are beyond 2^128,
// though five squares of U steps are not.
BOOST_AUTO_TEST_CASE(differences_that_round_to_the_reach_are_beyond_it)
{
  const Integer limit = sqrt(Integer(((Integer(1) << 128) - 1) / 5));
  const double units = static_cast<double>(Integer(limit >> 10 << 10));
  for(double excess = 0; excess < 1024; excess += 31)
    for(const int mode : rounding_modes)
      check_pair({Coordinates(5, units), Coordinates(5, -excess)}, units, 0, mode,
                 Arithmetic_tier::INT128);
}

// Checks what integers on the finest grid say of the points p and q, in every rounding mode. If
// `expected` is nothing, this is nothing, or false if a rounded difference is beyond the reach.
void check_decision(double r, const Coordinates& p, const Coordinates& q,
                    std::optional<bool> expected)
{
  const Bound bound(CGAL::within_distance(r));
  const int dimension = static_cast<int>(p.size());
  const internal::Integer_distance distance(
    bound, internal::finest_grid_exponent(bound.reach(), dimension), Arithmetic_tier::INT128);
  for(const int mode : rounding_modes) {
    const Rounding_mode in_mode(mode);
    const std::optional<bool> answer
      = distance.decide([&](int i) { return p[static_cast<std::size_t>(i)]; },
                        [&](int i) { return q[static_cast<std::size_t>(i)]; }, dimension);
    BOOST_CHECK(answer == expected || (!expected && mode != FE_TONEAREST && answer == false));
  }
}

BOOST_AUTO_TEST_CASE(points_that_are_not_on_the_grid_are_left_to_exact_numbers)
{
  for(const double r : {1., 0x1p-900, 0x1p900}) {
    const double tiny = 1e-30 * r;
    check_decision(r, {0, 0}, {r, 0}, true);
    check_decision(r, {0, tiny}, {r, 2 * tiny}, std::nullopt); // by one subtraction
    check_decision(r, {0, 0}, {r, tiny}, std::nullopt);        // by integers
    check_decision(r, {0, tiny}, {r, -r / 2}, std::nullopt);
    check_decision(r, {0, -tiny}, {r, tiny}, std::nullopt);
    check_decision(r, {0, tiny}, {r, tiny}, true);             // they differ along one axis only
    check_decision(r, {tiny, 0}, {r, 0}, std::nullopt);
    check_decision(r, {0, tiny}, {2 * r, -tiny}, false);
  }
  check_decision(0x1p900, {0, 0x1p-1000}, {0x1p900, 0x1p-999}, std::nullopt); // steps underflow
}

// As their grid is finer than that of the point that is closer to the origin.
BOOST_AUTO_TEST_CASE(all_numbers_as_long_as_the_bound_are_on_the_finest_grid)
{
  Random random(3);
  for(const double r : {5e-324, 1e-320, 1e-300, 0.1, 1e300, 0x1p1022})
    for(int i = 0; i < 1000; ++i) {
      const double x = r * (1 + random.uniform());
      const Rational gap = Rational(x) - Rational(r);
      check_decision(r, {r, 0}, {x, 0}, gap <= Rational(r));
      check_decision(r, {-r, 0}, {x, 0}, false);
    }
}

BOOST_AUTO_TEST_SUITE_END()
