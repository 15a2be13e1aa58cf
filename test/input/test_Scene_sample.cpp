// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a sample says about a scene is true of the points that it looks at.

#include "support/plain_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/Scene_sample.h>

BOOST_AUTO_TEST_SUITE(Scene_sample)

using namespace test_support;

BOOST_AUTO_TEST_CASE(sample_has_the_grid_of_its_points)
{
  const auto points = plain_points({{0.5, 4, 1e-9}, {-1, 8, 1e-9}, {0, 2.25, 1e-9}});
  const internal::Scene_sample sample(points);
  BOOST_CHECK(sample.may_have_grid());
  BOOST_CHECK_EQUAL(sample.grid_exponent(), -2);
  BOOST_CHECK_EQUAL(sample.extended_axis_count(), 2);
}

// Each second one of twice as many points as a sample has.
BOOST_AUTO_TEST_CASE(large_scenes_are_looked_at_from_end_to_end)
{
  Points points(1024, Coordinates{1, 1});
  points[1] = points[1023] = {0.5, 0.5};
  BOOST_CHECK_EQUAL(internal::Scene_sample(plain_points(points)).extended_axis_count(), 0);
  points[1022] = {0.25, 1};
  const internal::Scene_sample sample(plain_points(points));
  BOOST_CHECK_EQUAL(sample.extended_axis_count(), 1);
  BOOST_CHECK_EQUAL(sample.grid_exponent(), -2);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_no_doubles_have_no_grid)
{
  using Rational = CGAL::Exact_rational;
  Plain_points<Rational> points = plain_points<Rational>({{1, 2}, {0.5, 4}});
  BOOST_CHECK(internal::Scene_sample(points).may_have_grid());
  points[1].coordinates[1] /= 3;
  BOOST_CHECK(!internal::Scene_sample(points).may_have_grid());
}

BOOST_AUTO_TEST_CASE(lattices_are_repetitive_and_random_points_are_not)
{
  const auto is_repetitive = [](const Points& points) {
    return internal::Scene_sample(plain_points(points)).is_repetitive();
  };
  BOOST_CHECK(is_repetitive(lattice_points(2, 100, 0.1)));
  BOOST_CHECK(is_repetitive(lattice_points(3, 12, 0.1)));
  BOOST_CHECK(!is_repetitive(uniform_points(2, 1000, 0, 1, 1)));
  Points mixed = lattice_points(2, 100, 0.1);
  const Points uniform = uniform_points(2, mixed.size(), 0, 1, 1);
  for(std::size_t i = 0; i < mixed.size(); ++i)
    mixed[i][1] = uniform[i][1]; // along one axis only
  BOOST_CHECK(!is_repetitive(mixed));
  for(Coordinates& c : mixed)
    c[1] = 7; // along the only axis of the scene
  BOOST_CHECK(is_repetitive(mixed));
  BOOST_CHECK(!is_repetitive(Points(1000, Coordinates{1, 1})));
}

// The scan refuses such points later.
BOOST_AUTO_TEST_CASE(bad_points_are_passed_over)
{
  BOOST_CHECK_EQUAL(internal::Scene_sample(plain_points({})).extended_axis_count(), 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto points = plain_points(
    {{1, infinity}, {2, -infinity}, {4}, {6, infinity}, {nan, -infinity}, {8.5, 1, 3}});
  const internal::Scene_sample sample(points);
  BOOST_CHECK_EQUAL(sample.extended_axis_count(), 1);
  BOOST_CHECK_EQUAL(sample.grid_exponent(), 0);
}

BOOST_AUTO_TEST_SUITE_END()
