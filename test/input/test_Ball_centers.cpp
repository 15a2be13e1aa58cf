// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The centers of balls as a range, their intervals, and the radius that all balls have.

#include "support/rounding_mode.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

#include <boost/multiprecision/gmp.hpp>

BOOST_AUTO_TEST_SUITE(Ball_centers)

using namespace test_support;

using Balls = std::vector<std::pair<int, double>>; // on the line

BOOST_AUTO_TEST_CASE(centers_are_those_of_the_balls)
{
  const Balls balls = {{3, 1}, {1, 2}};
  const internal::Numbered_elements<Balls> elements(balls);
  const internal::Ball_centers<internal::Numbered_elements<Balls>> centers(elements);
  BOOST_CHECK_EQUAL(centers.size(), 2u);
  BOOST_CHECK(&centers[0] == &balls[0].first);
  BOOST_CHECK(&centers[1] == &balls[1].first);
}

BOOST_AUTO_TEST_CASE(the_interval_of_a_ball_holds_it_in_every_rounding_mode)
{
  using Rational = boost::multiprecision::mpq_rational;
  Random random(1);
  for(int i = 0; i < 1000; ++i)
    for(const int mode : rounding_modes) {
      const double center = random.uniform() - 0.5, radius = random.uniform();
      std::pair<double, double> interval;
      {
        const Rounding_mode rounding(mode);
        interval = internal::thickened_interval({center, center}, radius);
      }
      BOOST_REQUIRE(Rational(interval.first) <= Rational(center) - Rational(radius));
      BOOST_REQUIRE(Rational(interval.second) >= Rational(center) + Rational(radius));
      BOOST_REQUIRE_LE(interval.second - interval.first, 2 * radius + 0x1p-50);
    }
}

BOOST_AUTO_TEST_CASE(a_common_radius_is_that_of_all_balls)
{
  BOOST_CHECK(!internal::common_radius(Balls()));
  BOOST_CHECK_EQUAL(internal::common_radius(Balls{{3, 0.5}}).value(), 0.5);
  BOOST_CHECK_EQUAL(internal::common_radius(Balls{{3, 0.5}, {1, 0.5}, {0, 0.5}}).value(), 0.5);
  BOOST_CHECK(!internal::common_radius(Balls{{3, 0.5}, {1, 0.5}, {0, 0.25}}));
  BOOST_CHECK(!internal::common_radius(Balls{{3, 0.5}, {1, 0.25}, {0, 0.5}}));
}

BOOST_AUTO_TEST_SUITE_END()
