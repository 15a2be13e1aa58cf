// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the Cartesian kernels whose coordinates are exact numbers.

#define BOOST_TEST_MODULE kernels_exact
#include "support/check_kernel.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

using namespace test_support;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

BOOST_AUTO_TEST_CASE(epeck_2) { check_kernel<Cartesian_points<Epeck, 2>>(2); }
BOOST_AUTO_TEST_CASE(epeck_3) { check_kernel<Cartesian_points<Epeck, 3>>(3); }
BOOST_AUTO_TEST_CASE(rational_2) { check_kernel<Cartesian_points<Rational_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(rational_3) { check_kernel<Cartesian_points<Rational_kernel, 3>>(3); }

// Thirds are no doubles: a lattice of them has ties that only exact numbers see.
template <class Kernel>
void check_lattice_of_thirds()
{
  using FT = typename Kernel::FT;
  const Points lattice = lattice_points(2, 12, 1);
  std::vector<typename Kernel::Point_2> thirds;
  for(const Coordinates& c : lattice)
    thirds.emplace_back(FT(c[0]) / FT(3), FT(c[1]) / FT(3));
  const Truth truth = brute_force(lattice, Radius::of_square("5"));
  const auto bound = CGAL::within_squared_distance(CGAL::Exact_rational(5) / 9);

  const Pairs_difference closed = compare(truth.pairs, near_pairs(thirds, bound));
  BOOST_CHECK_MESSAGE(closed.empty(), closed);
  const Pairs_difference open = compare(truth.open_pairs, near_pairs(thirds, bound.open()));
  BOOST_CHECK_MESSAGE(open.empty(), open);
  BOOST_CHECK_GT(truth.boundary, 0u);
}

BOOST_AUTO_TEST_CASE(coordinates_between_the_doubles)
{
  check_lattice_of_thirds<Epeck>();
  check_lattice_of_thirds<Rational_kernel>();
}

// Coordinates beyond the range of doubles.
BOOST_AUTO_TEST_CASE(coordinates_beyond_the_doubles)
{
  CGAL::Exact_rational huge(1e300);
  huge *= huge;
  const std::vector<Rational_kernel::Point_2> points
    = {{huge, 0}, {huge + 3, 4}, {huge + 3, 5}, {-huge, 0}};
  const Pairs expected = {{0, 1}, {1, 2}};
  BOOST_CHECK(near_pairs(points, CGAL::within_distance(5)) == expected);
  const auto far = CGAL::within_distance(CGAL::Exact_rational(3 * huge));
  BOOST_CHECK_EQUAL(near_pairs(points, far).size(), 6u);
}
