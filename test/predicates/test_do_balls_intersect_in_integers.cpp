// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Balls in integers against integers of any length: ties and near ties on many grids, in every
// rounding mode.

#include "support/exact_points.h"
#include "support/point_generators.h"
#include "support/rounding_mode.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Do_balls_intersect.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

BOOST_AUTO_TEST_SUITE(do_balls_intersect_in_integers)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

constexpr int max_dimension = 8;

// Two balls in steps of a grid: integers, as doubles.
struct Balls
{
  std::array<double, max_dimension> p, q;
  double r, s;
};

// Centers with coordinates of up to `bits` bits, and radii whose sum is the distance, up to one
// step.
Balls nearly_touching_balls(int dimension, int bits, Random& random)
{
  Balls balls;
  const auto coordinate = [&] {
    return static_cast<double>(random.below(std::uint64_t(1) << bits))
           - std::ldexp(1., bits - 1);
  };
  Integer sum = 0;
  for(int i = 0; i < dimension; ++i) {
    balls.p[i] = coordinate();
    balls.q[i] = i > 0 && random.below(2) == 0 ? balls.p[i] : coordinate();
    const Integer gap = Integer(balls.p[i]) - Integer(balls.q[i]);
    sum += gap * gap;
  }
  const Integer root = sqrt(sum);
  const double total = static_cast<double>(root) + static_cast<double>(random.below(3)) - 1;
  balls.r = std::floor((std::max)(total, 0.) * 0.375);
  balls.s = (std::max)(total, 0.) - balls.r;
  return balls;
}

bool do_intersect_exactly(const Balls& balls, int dimension)
{
  const Integer radii = Integer(balls.r) + Integer(balls.s);
  Integer sum = -radii * radii;
  for(int i = 0; i < dimension; ++i) {
    const Integer gap = Integer(balls.p[i]) - Integer(balls.q[i]);
    sum += gap * gap;
  }
  return sum.sign() <= 0;
}

std::optional<bool> decide(const Balls& balls, int dimension, int exponent)
{
  const auto scaled = [&](double steps) { return std::ldexp(steps, exponent); };
  return internal::do_balls_intersect_in_integers(
    [&](int i) { return scaled(balls.p[i]); }, scaled(balls.r),
    [&](int i) { return scaled(balls.q[i]); }, scaled(balls.s), dimension);
}

BOOST_AUTO_TEST_CASE(near_ties_are_decided_on_every_grid)
{
  Random random(17);
  int touching = 0;
  for(const int mode : rounding_modes)
    for(int trial = 0; trial < 20000; ++trial) {
      const int dimension = 1 + static_cast<int>(random.below(max_dimension));
      const int bits = 2 + static_cast<int>(random.below(49));
      const int exponent = static_cast<int>(random.below(1900)) - 1070;
      const Balls balls = nearly_touching_balls(dimension, bits, random);
      const bool expected = do_intersect_exactly(balls, dimension);
      const Rounding_mode guard(mode);
      const std::optional<bool> is = decide(balls, dimension, exponent);
      BOOST_REQUIRE(is.has_value());
      BOOST_REQUIRE_EQUAL(*is, expected);
      touching += expected;
    }
  BOOST_TEST(touching > 10000);
}

BOOST_AUTO_TEST_CASE(numbers_that_do_not_fit_are_left_undecided)
{
  const auto origin = [](int) { return 0.; };
  const auto fine = [](int) { return 0x1p-70; };
  BOOST_TEST(!internal::do_balls_intersect_in_integers(origin, 1., fine, 0., 2).has_value());
  BOOST_TEST(!internal::do_balls_intersect_in_integers(origin, 1., origin, 1., 9).has_value());
  BOOST_TEST(internal::do_balls_intersect_in_integers(origin, 0., origin, 0., 8).value());
}

BOOST_AUTO_TEST_CASE(centers_far_from_each_other_are_beyond_the_radii)
{
  const auto low = [](int) { return -0x1p1023; };
  const auto high = [](int) { return 0x1p1023; };
  BOOST_TEST(!internal::do_balls_intersect_in_integers(low, 1., high, 1., 3).value());
  BOOST_TEST(internal::do_balls_intersect_in_integers(low, 0x1p1023, high, 0x1p1023, 1).value());
  BOOST_TEST(!internal::do_balls_intersect_in_integers(low, 0x1p1023, high, 0x1p1023, 2).value());
}

BOOST_AUTO_TEST_SUITE_END()
