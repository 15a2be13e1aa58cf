// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The centers of balls as a range, and the radius that all balls have.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>

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

BOOST_AUTO_TEST_CASE(a_common_radius_is_that_of_all_balls)
{
  BOOST_CHECK(!internal::common_radius(Balls()));
  BOOST_CHECK_EQUAL(internal::common_radius(Balls{{3, 0.5}}).value(), 0.5);
  BOOST_CHECK_EQUAL(internal::common_radius(Balls{{3, 0.5}, {1, 0.5}, {0, 0.5}}).value(), 0.5);
  BOOST_CHECK(!internal::common_radius(Balls{{3, 0.5}, {1, 0.5}, {0, 0.25}}));
  BOOST_CHECK(!internal::common_radius(Balls{{3, 0.5}, {1, 0.25}, {0, 0.5}}));
}

BOOST_AUTO_TEST_SUITE_END()
