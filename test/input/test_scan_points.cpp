// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What one scan finds of points: box, error, grid, and the first bad point.

#include "support/error_messages.h"
#include "support/plain_points.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/scan_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

BOOST_AUTO_TEST_SUITE(scan_points)

using namespace test_support;

template <class Number>
internal::Scene scene_of(const Plain_points<Number>& points)
{
  return internal::scan_points(points, "point");
}

BOOST_AUTO_TEST_CASE(the_box_holds_all_points_and_no_more)
{
  const Points points = uniform_points(3, 500, -0.5, 1, 1);
  const internal::Scene scene = scene_of(plain_points(points));
  BOOST_CHECK_EQUAL(scene.size, 500u);
  BOOST_REQUIRE_EQUAL(scene.dimension(), 3);
  for(std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> x;
    for(const Coordinates& c : points)
      x.push_back(c[axis]);
    BOOST_CHECK_EQUAL(scene.box[axis].low, *std::min_element(x.begin(), x.end()));
    BOOST_CHECK_EQUAL(scene.box[axis].high, *std::max_element(x.begin(), x.end()));
  }
}

// Otherwise all pairs would be within the error of a search.
BOOST_AUTO_TEST_CASE(a_lazy_number_without_leading_bits_is_made_exact)
{
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  const Epeck::FT large = 1e16;
  const Epeck::Point_2 wide((large + 0.25) - large, 0.5), other(0.75, 1);
  const internal::Scene scene = internal::scan_points(std::vector{other, wide, other}, "point");
  BOOST_CHECK_EQUAL(scene.error, 0);
  BOOST_CHECK_EQUAL(scene.box[0].low, 0.25);
  BOOST_CHECK_EQUAL(scene.grid_exponent.value(), -2);
}

BOOST_AUTO_TEST_CASE(the_first_bad_point_of_all_blocks_is_kept)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Plain_points<double> points = plain_points({{0}, {nan}, {nan}, {1}});
  internal::Scene_scan all(1, true), low(1, true), high(1, true);
  low.add(points, 0, 2, [](std::size_t, int, double) {});
  high.add(points, 2, 4, [](std::size_t, int, double) {});
  all.add(low);
  all.add(high);
  BOOST_CHECK_EQUAL(all.first_bad(), 1u);
}

BOOST_AUTO_TEST_CASE(only_axes_along_which_points_differ_have_a_say_in_the_grid)
{
  const internal::Scene scene = scene_of(plain_points({{0.25, 0.1, -0.}, {4, 0.1, 0.}}));
  BOOST_CHECK_EQUAL(scene.extended_axis_count(), 1);
  BOOST_CHECK(scene.is_extended_along(0) && !scene.is_extended_along(1));
  BOOST_CHECK_EQUAL(scene.grid_exponent.value(), -2);
  BOOST_CHECK_EQUAL(scene_of(plain_points({{0.1}, {0.1}})).grid_exponent.value(), 0);
  BOOST_CHECK_EQUAL(scene_of(plain_points({{3, 0.5}, {5, 1}})).grid_exponent.value(), -1);
}

BOOST_AUTO_TEST_CASE(the_error_is_zero_if_and_only_if_all_coordinates_are_doubles)
{
  using Rational = CGAL::Exact_rational;
  auto points = plain_points<Rational>({{0.1, 3}, {-7, 5e-324}});
  const internal::Scene of_doubles = scene_of(points);
  BOOST_CHECK_EQUAL(of_doubles.error, 0);
  BOOST_CHECK_EQUAL(of_doubles.grid_exponent.value(), -1074);

  points[1].coordinates[0] = Rational(1) / 3;
  const internal::Scene scene = scene_of(points);
  BOOST_CHECK(!scene.grid_exponent);
  BOOST_CHECK_GT(scene.error, 0);
  BOOST_CHECK_LT(scene.error, 1e-15);
  BOOST_CHECK(Rational(scene.box[0].high) >= points[1].coordinates[0]);
  BOOST_CHECK(Rational(scene.box[0].high) - points[1].coordinates[0] <= Rational(scene.error));
  BOOST_CHECK_EQUAL(scene.box[0].low, 0.1);
}

BOOST_AUTO_TEST_CASE(lower_bounds_are_stored_once_each)
{
  using Rational = CGAL::Exact_rational;
  Plain_points<Rational> points = plain_points<Rational>({{1, 2}, {0.5, 4}, {-1, 8}});
  points[2].coordinates[0] = -Rational(1) / 3;
  std::vector<std::tuple<std::size_t, int, double>> stored;
  const internal::Scene scene = internal::scan_points(
    points, "point", false,
    [&](std::size_t position, int axis, double x) { stored.emplace_back(position, axis, x); },
    internal::Threads());
  BOOST_CHECK(!scene.grid_exponent);
  BOOST_CHECK_GT(scene.error, 0);
  BOOST_REQUIRE_EQUAL(stored.size(), 6u);
  for(std::size_t i = 0; i < stored.size(); ++i) {
    const auto [position, axis, x] = stored[i];
    BOOST_CHECK_EQUAL(2 * position + static_cast<std::size_t>(axis), i);
    const Rational gap = points[position].coordinates[static_cast<std::size_t>(axis)] - Rational(x);
    BOOST_CHECK(gap >= 0 && gap <= Rational(scene.error));
  }
}

BOOST_AUTO_TEST_CASE(the_grid_is_found_if_it_is_asked_for)
{
  const auto points = plain_points({{0.5, 4, 1e-9}, {-1, 8, 1e-9}, {0, 2.25, 1e-9}});
  const internal::Scene with = scene_of(points);
  const internal::Scene without = internal::scan_points(points, "point", false);
  BOOST_CHECK(with.grid_exponent == -2);
  BOOST_CHECK(!without.grid_exponent);
  BOOST_CHECK_EQUAL(without.size, with.size);
  BOOST_CHECK_EQUAL(without.error, 0);
  for(std::size_t axis = 0; axis < 3; ++axis) {
    BOOST_CHECK_EQUAL(without.box[axis].low, with.box[axis].low);
    BOOST_CHECK_EQUAL(without.box[axis].high, with.box[axis].high);
  }
}

BOOST_AUTO_TEST_CASE(the_first_bad_point_is_named)
{
  auto points = plain_points(uniform_points(2, 20, 0, 1, 2));
  const auto refusal = [&] { return error_message([&] { scene_of(points); }); };
  BOOST_CHECK_EQUAL(refusal(), "");
  points[17].coordinates[0] = -infinity;
  BOOST_CHECK_EQUAL(refusal(), "Coordinate 0 of point 17 is NaN or infinite.");
  points[9].coordinates.push_back(0);
  BOOST_CHECK_EQUAL(refusal(), "point 9 has dimension 3 instead of 2.");
  points[4].coordinates[1] = std::nan("");
  BOOST_CHECK_EQUAL(refusal(), "Coordinate 1 of point 4 is NaN or infinite.");
}

// The type of points of the plane tells a dimension that the scene does not have.
BOOST_AUTO_TEST_CASE(no_points_make_an_empty_scene)
{
  const std::vector<CGAL::Simple_cartesian<double>::Point_2> none;
  for(const internal::Scene& scene :
      {scene_of(Plain_points<double>()), internal::scan_points(none, "point")}) {
    BOOST_CHECK_EQUAL(scene.size, 0u);
    BOOST_CHECK_EQUAL(scene.dimension(), 0);
    BOOST_CHECK_EQUAL(scene.error, 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
