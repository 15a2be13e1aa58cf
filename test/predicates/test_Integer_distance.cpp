// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distances in integers of 64 and 128 bits against integers of any length: near ties up to the
// limits of each, far from the origin, in every rounding mode.

#include "support/exact_points.h"
#include "support/point_generators.h"
#include "support/rounding_mode.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>

BOOST_AUTO_TEST_SUITE(Integer_distance)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

using Bound = internal::Squared_bound<internal::Exact_number_t<double>>;

// Coordinates in steps of the grid: integers, as doubles.
struct Pair_of_points
{
  Coordinates p, q;
};

// Negative, zero or positive as the points are closer than U steps, at U steps or beyond.
int compare(const Pair_of_points& pair, double units)
{
  Integer sum = -Integer(units) * Integer(units);
  for(std::size_t axis = 0; axis < pair.p.size(); ++axis) {
    const Integer difference = Integer(pair.p[axis]) - Integer(pair.q[axis]);
    sum += difference * difference;
  }
  return sum.sign();
}

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

template <class Square>
void check_pair(const Pair_of_points& pair, double units, int exponent, int mode)
{
  const int sign = compare(pair, units);
  const auto x = [&](int i) { return std::ldexp(pair.p[static_cast<std::size_t>(i)], exponent); };
  const auto y = [&](int i) { return std::ldexp(pair.q[static_cast<std::size_t>(i)], exponent); };
  const auto bound = CGAL::within_distance(std::ldexp(units, exponent));
  const int dimension = static_cast<int>(pair.p.size());
  bool closed, open;
  {
    const Rounding_mode in_mode(mode);
    closed = internal::Integer_distance<Square>(Bound(bound), exponent).holds_for(x, y, dimension);
    open = internal::Integer_distance<Square>(Bound(bound.open()), exponent)
             .holds_for(x, y, dimension);
  }
  BOOST_TEST_CONTEXT(units << " steps of 2^" << exponent << ", rounding mode " << mode)
  {
    BOOST_CHECK_EQUAL(closed, sign <= 0);
    BOOST_CHECK_EQUAL(open, sign < 0);
  }
}

template <class Square>
void check_near_ties(int dimension, double units)
{
  Random random(1);
  for(const int mode : rounding_modes)
    for(const int exponent : {0, -1074, -30, 900})
      for(int i = 0; i < 100; ++i)
        check_pair<Square>(near_tie(dimension, units, random), units, exponent, mode);
}

BOOST_AUTO_TEST_CASE(near_ties_in_64_bits)
{
  for(const double units : {0., 1., 5., 67108865., 2147483647.})
    check_near_ties<std::uint64_t>(2, units);
  check_near_ties<std::uint64_t>(1, 3037000499.);
  check_near_ties<std::uint64_t>(3, 1753413056.);
}

BOOST_AUTO_TEST_CASE(near_ties_in_128_bits)
{
  const double last_exact = 0x1p53;
  for(const double units : {5., 2147483648., last_exact - 1, last_exact, last_exact + 2, 1e18,
                            0x1p63 - 1024})
    for(const int dimension : {1, 2, 3, 4})
      check_near_ties<internal::Uint128>(dimension, units);
}

// At the reach, and one step beyond it, along a single axis and far from the origin.
BOOST_AUTO_TEST_CASE(one_step_beyond_the_reach_is_beyond)
{
  for(const double units : {3., 1000000., 0x1p40})
    for(const double offset : {0., 0x1p20, -0x1p52, 0x1p52 - 7})
      for(const double step : {-1., 0., 1.})
        for(const int mode : rounding_modes) {
          const Pair_of_points pair = {{offset, 1}, {offset + units + step, 1}};
          check_pair<internal::Uint128>(pair, units, -20, mode);
          if(units < 0x1p31)
            check_pair<std::uint64_t>(pair, units, -20, mode);
        }
}

// Differences of 2^64 steps are zero modulo 2^64.
BOOST_AUTO_TEST_CASE(points_a_multiple_of_2_to_64_steps_apart_are_far)
{
  for(const double units : {0x1p53, 0x1p62})
    for(const double far : {0x1p64, -0x1p64, 0x1p70, 0x1p64 + 0x1p12})
      for(const int mode : rounding_modes)
        check_pair<internal::Uint128>({{0, 0}, {far, 0}}, units, 0, mode);
}

// Differences that are longer than U steps and round to U: five of their squares are beyond 2^128,
// though five squares of U steps are not.
BOOST_AUTO_TEST_CASE(differences_that_round_to_the_reach_are_beyond_it)
{
  const Integer limit = sqrt(Integer(((Integer(1) << 128) - 1) / 5));
  const double units = static_cast<double>(Integer(limit >> 10 << 10));
  for(double excess = 0; excess < 1024; excess += 31)
    for(const int mode : rounding_modes)
      check_pair<internal::Uint128>({Coordinates(5, units), Coordinates(5, -excess)}, units, 0,
                                    mode);
}

BOOST_AUTO_TEST_SUITE_END()
