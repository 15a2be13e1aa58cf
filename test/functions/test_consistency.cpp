// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Answers that must agree with each other, on scenes too large for brute force: under permutation,
// exchange of axes, exact scaling and translation, embedding, splitting in two sets; and with the
// closed-form counts of lattices.

#include "support/kernels.h"
#include "support/lattice_counts.h"
#include "support/unit_test.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane = Cartesian_points<Epick, 2>;
using Space = Cartesian_points<Epick, 3>;

namespace {

template <class Maker>
Pairs pairs_of(const Points& points, double r)
{
  return sorted(near_pairs(make_points<Maker>(points), CGAL::within_distance(r)));
}

// Each coordinate replaced by f of it.
template <class Function>
Points mapped(Points points, const Function& f)
{
  for(Coordinates& c : points)
    for(double& x : c)
      x = f(x);
  return points;
}

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

constexpr double radius = 0.1;

template <class Maker>
void check_permutation(int dimension)
{
  const Points points = mixed_scene(dimension);
  const Pairs pairs = pairs_of<Maker>(points, radius);
  BOOST_REQUIRE_GT(pairs.size(), 10000u);

  std::vector<std::size_t> order(points.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = (i * 1237 + 11) % order.size(); // the size has no divisor in common with 1237
  Points permuted;
  for(const std::size_t i : order)
    permuted.push_back(points[i]);
  Pairs named_back;
  for(const Pair& p : pairs_of<Maker>(permuted, radius))
    named_back.push_back(std::minmax(order[p.first], order[p.second]));
  BOOST_CHECK(sorted(named_back) == pairs);
}

template <class Maker>
void check_exact_maps(int dimension)
{
  const Points points = mixed_scene(dimension);
  const Pairs pairs = pairs_of<Maker>(points, radius);

  Points reversed = points; // the axes in the other order
  for(Coordinates& c : reversed)
    std::reverse(c.begin(), c.end());
  BOOST_CHECK(pairs_of<Maker>(reversed, radius) == pairs);
  BOOST_CHECK(pairs_of<Maker>(mapped(points, [](double x) { return -x; }), radius) == pairs);
  for(const int exponent : {-600, -40, 1, 600}) {
    const auto scale = [&](double x) { return std::ldexp(x, exponent); };
    BOOST_CHECK(pairs_of<Maker>(mapped(points, scale), scale(radius)) == pairs);
  }

  const auto to_grid = [](double x) { return std::ldexp(std::floor(std::ldexp(x, 20)), -20); };
  const Points on_grid = mapped(points, to_grid);
  const Pairs grid_pairs = pairs_of<Maker>(on_grid, radius);
  for(const double offset : {1e9, -3e9 - 0.5})
    BOOST_CHECK(pairs_of<Maker>(mapped(on_grid, [&](double x) { return x + offset; }), radius)
                == grid_pairs);
}

template <class Maker>
void check_two_sets(int dimension)
{
  const Points points = mixed_scene(dimension);
  const std::size_t half = points.size() / 3;
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(half);
  const Points a(points.begin(), middle), b(middle, points.end());

  Pairs together = pairs_of<Maker>(a, radius);
  for(const Pair& p : pairs_of<Maker>(b, radius))
    together.emplace_back(half + p.first, half + p.second);
  for(const Pair& p : near_pairs(make_points<Maker>(a), make_points<Maker>(b),
                                 CGAL::within_distance(radius)))
    together.emplace_back(p.first, half + p.second);
  BOOST_CHECK(sorted(together) == pairs_of<Maker>(points, radius));
}

} // namespace

BOOST_AUTO_TEST_CASE(permutation_2) { check_permutation<Plane>(2); }
BOOST_AUTO_TEST_CASE(permutation_3) { check_permutation<Space>(3); }
BOOST_AUTO_TEST_CASE(exact_maps_2) { check_exact_maps<Plane>(2); }
BOOST_AUTO_TEST_CASE(exact_maps_3) { check_exact_maps<Space>(3); }
BOOST_AUTO_TEST_CASE(two_sets_2) { check_two_sets<Plane>(2); }
BOOST_AUTO_TEST_CASE(two_sets_3) { check_two_sets<Space>(3); }

BOOST_AUTO_TEST_CASE(plane_in_space)
{
  const Points points = mixed_scene(2);
  const Pairs pairs = pairs_of<Plane>(points, radius);
  for(int axis = 0; axis < 3; ++axis) {
    Points lifted = points;
    for(Coordinates& c : lifted)
      c.insert(c.begin() + axis, 0.3);
    BOOST_CHECK(pairs_of<Space>(lifted, radius) == pairs);
  }
}

BOOST_AUTO_TEST_CASE(larger_radius_reports_more)
{
  const Points points = shuffled(lattice_points(2, 60, 0.125, -3), 5);
  const Pairs all = pairs_of<Plane>(points, 0.25);
  const Pairs fewer = pairs_of<Plane>(points, std::nextafter(0.25, 0.));
  const std::size_t ties = lattice_count(60, 2, 4).at_threshold;
  BOOST_CHECK_EQUAL(all.size(), fewer.size() + ties);
  BOOST_CHECK(std::includes(all.begin(), all.end(), fewer.begin(), fewer.end()));
}

// m copies of each of n points: m^2 k + n m(m - 1)/2 pairs.
BOOST_AUTO_TEST_CASE(copies_multiply)
{
  const Points points = clustered_points(2, 1000, 10, 1. / 16, 6);
  const std::size_t k = pairs_of<Plane>(points, 0.01).size();
  BOOST_CHECK_EQUAL(pairs_of<Plane>(repeated(points, 5), 0.01).size(), 25 * k + 1000 * 10);
}

// Ties by the million, counted in closed form.
BOOST_AUTO_TEST_CASE(lattices_have_the_closed_form_counts)
{
  const auto count = [](const auto& points, const auto& bound) {
    std::uint64_t pairs = 0;
    CGAL::fixed_radius_near_neighbors(points, bound,
                                      [&](std::size_t, std::size_t) { ++pairs; });
    return pairs;
  };
  const auto plane = make_points<Plane>(lattice_points(2, 300, 0.5));
  const Lattice_count expected_2 = lattice_count(300, 2, 25);
  BOOST_CHECK_EQUAL(count(plane, CGAL::within_distance(2.5)), expected_2.pairs);
  BOOST_CHECK_EQUAL(count(plane, CGAL::within_distance(2.5).open()),
                    expected_2.pairs - expected_2.at_threshold);

  const auto space = make_points<Space>(lattice_points(3, 40, 1));
  const Lattice_count expected_3 = lattice_count(40, 3, 6);
  BOOST_CHECK_EQUAL(count(space, CGAL::within_squared_distance(6)), expected_3.pairs);
  BOOST_CHECK_EQUAL(count(space, CGAL::within_squared_distance(6).open()),
                    expected_3.pairs - expected_3.at_threshold);
}
