// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A filter is never wrong: distances next to the bound, against rational numbers, in every rounding
// mode, of coordinates that are doubles and of others that are near doubles.

#include "support/exact_points.h"
#include "support/rounding_mode.h"
#include "support/squared_distance.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

BOOST_AUTO_TEST_SUITE(Distance_filter)

using namespace test_support;

using Bound = internal::Squared_bound<internal::Exact_number_t<double>>;

// What a filter says of a computed square must hold for the exact one, whether the bound is closed
// or open. Returns whether it says anything.
bool check_filter(const internal::Distance_filter& filter, double computed, const Rational& exact,
                  double r)
{
  const Rational square = Rational(r) * Rational(r);
  if(computed <= filter.inside)
    BOOST_CHECK(exact < square);
  if(computed > filter.outside)
    BOOST_CHECK(exact > square);
  return computed <= filter.inside || computed > filter.outside;
}

// A point at a distance from p that is r up to a relative difference of about `width`.
Coordinates point_near_sphere(const Coordinates& p, double r, double width, Random& random)
{
  Coordinates direction;
  double square = 0;
  for(std::size_t axis = 0; axis < p.size(); ++axis) {
    direction.push_back(random.uniform() - 0.5);
    square += direction.back() * direction.back();
  }
  const double factor = r * (1 + width * (random.uniform() - 0.5)) / std::sqrt(square);
  for(std::size_t axis = 0; axis < p.size(); ++axis)
    direction[axis] = p[axis] + factor * direction[axis];
  return direction;
}

// Radii of every magnitude, so that squares vanish and overflow as well.
BOOST_AUTO_TEST_CASE(filters_are_right_next_to_the_bound)
{
  Random random(1);
  for(const int mode : rounding_modes)
    for(const int dimension : {1, 2, 3, 6})
      for(int exponent = -1060; exponent < 1020; exponent += 10) {
        const double r = std::ldexp(1 + random.uniform(), exponent);
        const Coordinates p(static_cast<std::size_t>(dimension), 0.3 * r);
        for(const double width : {0., 1e-15, 1e-14, 1.}) {
          const Coordinates q = point_near_sphere(p, r, width, random);
          internal::Distance_filter filter;
          double computed;
          {
            const Rounding_mode in_mode(mode);
            filter = internal::make_distance_filter(Bound(CGAL::within_distance(r)), dimension);
            computed = squared_distance<double>(p, q);
          }
          check_filter(filter, computed, squared_distance<Rational>(p, q), r);
        }
      }
}

BOOST_AUTO_TEST_CASE(filters_decide_nearly_all)
{
  Random random(2);
  std::size_t decided = 0;
  for(int i = 0; i < 1000; ++i) {
    const double r = std::ldexp(1 + random.uniform(), static_cast<int>(random.below(900)) - 450);
    const Coordinates p = {r, -r, r};
    const Coordinates q = point_near_sphere(p, r, 1e-10, random);
    const Bound bound(CGAL::within_distance(r));
    decided += check_filter(internal::make_distance_filter(bound, 3),
                            squared_distance<double>(p, q),
                            squared_distance<Rational>(p, q), r);
  }
  BOOST_CHECK_GE(decided, 990u);
}

// A coordinate is above its double by up to the error.
std::vector<Rational> moved_up(const Coordinates& c, double error, Random& random)
{
  std::vector<Rational> moved;
  for(const double x : c) {
    const double shares[] = {0, 1, random.uniform()};
    moved.push_back(Rational(x) + Rational(error) * Rational(shares[random.below(3)]));
  }
  return moved;
}

BOOST_AUTO_TEST_CASE(widened_filters_are_right_for_doubles_below_the_coordinates)
{
  Random random(3);
  std::size_t decided = 0;
  for(const int mode : rounding_modes)
    for(int i = 0; i < 5000; ++i) {
      const double r = std::ldexp(1 + random.uniform(), static_cast<int>(random.below(960)) - 480);
      const double error = r * std::ldexp(random.uniform(), -static_cast<int>(random.below(60)));
      const Coordinates p = {r, 0, -r};
      const Coordinates q = point_near_sphere(p, r, 8 * error / r, random);
      internal::Distance_filter wide;
      double computed;
      {
        const Rounding_mode in_mode(mode);
        const Bound bound(CGAL::within_distance(r));
        wide = internal::widen(internal::make_distance_filter(bound, 3), bound, error);
        computed = squared_distance<double>(p, q);
      }
      const std::vector<Rational> exact_p = moved_up(p, error, random);
      const std::vector<Rational> exact_q = moved_up(q, error, random);
      decided += check_filter(wide, computed, squared_distance<Rational>(exact_p, exact_q), r);
    }
  BOOST_CHECK_GT(decided, 2000u);
}

// Doubles are off by less than twice the error, and so are their distances; then these are rounded.
BOOST_AUTO_TEST_CASE(widened_filters_have_room_for_the_error_and_for_rounding)
{
  for(int i = 0; i < 100; ++i) {
    const double r = 1 + i / 100.;
    const double error = std::ldexp(r, -30 - i / 4);
    const Bound bound(CGAL::within_distance(r));
    const internal::Distance_filter wide
      = internal::widen(internal::make_distance_filter(bound, 3), bound, error);
    const Rational room = Rational(internal::relative_error(3));
    const Rational longest = Rational(r) + 2 * Rational(error);
    const Rational shortest = Rational(r) - 2 * Rational(error);
    BOOST_CHECK(Rational(wide.outside) >= longest * longest * (1 + room));
    BOOST_CHECK(Rational(wide.inside) <= shortest * shortest * (1 - room));
  }
  for(const int exponent : {-600, -500, 0, 510}) {
    const Bound bound(CGAL::within_distance(std::ldexp(1., exponent)));
    const internal::Distance_filter filter = internal::make_distance_filter(bound, 3);
    const internal::Distance_filter wide
      = internal::widen(filter, bound, std::ldexp(1., exponent - 40));
    BOOST_CHECK_GE(wide.outside, filter.outside);
    BOOST_CHECK_LE(wide.inside, filter.inside);
  }
}

// Each square is rounded up to a denormal number, which is twice as large.
BOOST_AUTO_TEST_CASE(squares_that_are_nearly_lost_are_not_beyond_the_bound)
{
  const double gap = std::ldexp(0x1.6a09e667f3bcdp-1, -537); // above the root of 2^-1075
  const Rational square = 3 * Rational(gap) * Rational(gap);
  const CGAL::Exact_rational exact_gap(gap);
  const internal::Squared_bound<CGAL::Exact_rational> bound(
    CGAL::within_squared_distance(CGAL::Exact_rational(3 * exact_gap * exact_gap)));
  const Coordinates p = {0, 0, 0}, q = {gap, gap, gap};
  const double computed = squared_distance<double>(p, q);
  BOOST_REQUIRE(Rational(computed) > Rational(bound.squared().second));
  BOOST_CHECK(squared_distance<Rational>(p, q) == square);
  BOOST_CHECK_LE(computed, internal::make_distance_filter(bound, 3).outside);
}

BOOST_AUTO_TEST_CASE(nothing_is_beyond_an_infinite_bound)
{
  const Bound bound(CGAL::within_distance(infinity));
  const internal::Distance_filter filter = internal::make_distance_filter(bound, 2);
  BOOST_CHECK_EQUAL(filter.inside, infinity);
  BOOST_CHECK_EQUAL(internal::widen(filter, bound, 1).inside, infinity);
}

BOOST_AUTO_TEST_SUITE_END()
