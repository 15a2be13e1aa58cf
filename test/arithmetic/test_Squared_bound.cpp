// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The squared bound in doubles and in steps of a grid, against rational numbers.

#include "support/exact_points.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(Squared_bound)

using namespace test_support;

const double infinity = std::numeric_limits<double>::infinity();

// The threshold of the certified tier is the square of the radius rounded down, to the last bit.
BOOST_AUTO_TEST_CASE(thresholds_are_the_largest_doubles_within)
{
  using Bound = CGAL::Thick_intersection_d::internal::Squared_bound<CGAL::Exact_rational>;
  BOOST_CHECK_EQUAL(Bound(CGAL::within_distance(5)).largest_double(), 25);
  BOOST_CHECK_EQUAL(Bound(CGAL::within_distance(5).open()).largest_double(),
                    std::nextafter(25., 0.));
  BOOST_CHECK_LT(Bound(CGAL::within_distance(0).open()).largest_double(), 0);
  for(double r = 0.1; r < 3; r += 0.1) {
    const double threshold = Bound(CGAL::within_distance(r)).largest_double();
    const Rational r2 = Rational(r) * Rational(r);
    BOOST_CHECK(Rational(threshold) <= r2);
    BOOST_CHECK(Rational(std::nextafter(threshold, infinity)) > r2);
  }
}

BOOST_AUTO_TEST_SUITE_END()
