// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of thousands of points against brute force, at all scales and far from the origin; and the
// closed-form counts of lattices.

#include "support/check_kernel.h"
#include "support/lattice_counts.h"

using namespace test_support;

namespace {

// A scene with ties, duplicates and empty parts; its numbers are no binary fractions.
Points mixed_scene(int dimension)
{
  Points points = clustered_points(dimension, 4000, 30, 1. / 32, 3);
  for(const Coordinates& c : lattice_points(dimension, dimension == 2 ? 40 : 12, 0.1, -2))
    points.push_back(c);
  for(std::size_t i = 0; i < 500; ++i)
    points.push_back(points[7 * i]);
  return shuffled(points, 4);
}

// The truth is the same at all scales, and on a grid wherever it is.
template <class Maker>
void check_large_scene(int dimension)
{
  const double radius = 0.1;
  const Point_scene mixed
    = scene("mixed", dimension, mixed_scene(dimension), Radius::of_length(radius));
  BOOST_REQUIRE_GT(truth_of(mixed).pairs.size(), 10000u);
  check_scene<Maker>(mixed);
  for(const int exponent : {-600, -40, 1, 600}) {
    const double unit = std::ldexp(1, exponent);
    check_pairs(exponent, truth_of(mixed).pairs,
                near_pairs(make_points<Maker>(moved(mixed.points, unit, 0)),
                           CGAL::within_distance(unit * radius)));
  }
  Point_scene on_grid = mixed;
  for(Coordinates& c : on_grid.points)
    for(double& x : c)
      x = std::ldexp(std::floor(std::ldexp(x, 20)), -20);
  for(const double offset : {1e9, -3e9 - 0.5})
    check_pairs(offset, truth_of(on_grid).pairs,
                near_pairs(make_points<Maker>(moved(on_grid.points, 1, offset)),
                           CGAL::within_distance(radius)));
}

} // namespace

BOOST_AUTO_TEST_CASE(large_scene_of_the_plane) { check_large_scene<Epick_points<2>>(2); }
BOOST_AUTO_TEST_CASE(large_scene_of_space) { check_large_scene<Epick_points<3>>(3); }

// Ties by the million, counted in closed form.
BOOST_AUTO_TEST_CASE(lattices_have_the_closed_form_counts)
{
  const auto count = [](const auto& points, const auto& bound) {
    std::uint64_t pairs = 0;
    CGAL::fixed_radius_near_neighbors(points, bound,
                                      [&](std::size_t, std::size_t) { ++pairs; });
    return pairs;
  };
  const auto plane = make_points<Epick_points<2>>(lattice_points(2, 300, 0.5));
  const Lattice_count expected_2 = lattice_count(300, 2, 25);
  BOOST_CHECK_EQUAL(count(plane, CGAL::within_distance(2.5)), expected_2.pairs);
  BOOST_CHECK_EQUAL(count(plane, CGAL::within_distance(2.5).open()),
                    expected_2.pairs - expected_2.at_threshold);

  const auto space = make_points<Epick_points<3>>(lattice_points(3, 40, 1));
  const Lattice_count expected_3 = lattice_count(40, 3, 6);
  BOOST_CHECK_EQUAL(count(space, CGAL::within_squared_distance(6)), expected_3.pairs);
  BOOST_CHECK_EQUAL(count(space, CGAL::within_squared_distance(6).open()),
                    expected_3.pairs - expected_3.at_threshold);
}
