// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The constants of packing: how many points a cell holds.

#include "support/check_closest_pair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

BOOST_AUTO_TEST_SUITE(packing)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Maker = Cartesian_points<Epick, Dimension>;

// The corners of a cube with edges as long as the bound, and its centre: 2^d points that are not
// closer, and in dimension 4 one more. All of them are in one cell, as its side is a little longer.
BOOST_AUTO_TEST_CASE(as_many_points_as_a_cell_holds)
{
  const auto corners = make_points<Maker<2>>(lattice_points(2, 2, 3, 1));
  BOOST_CHECK(CGAL::has_close_pair(corners, CGAL::within_distance(3)));
  BOOST_CHECK(!CGAL::has_close_pair(corners, CGAL::within_distance(3).open()));
  const auto corners_3 = make_points<Maker<3>>(lattice_points(3, 2, 3, 1));
  BOOST_CHECK(CGAL::has_close_pair(corners_3, CGAL::within_distance(3)));
  BOOST_CHECK(!CGAL::has_close_pair(corners_3, CGAL::within_distance(3).open()));
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(1), 2u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(2), 4u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(3), 8u);
  BOOST_CHECK_EQUAL(internal::max_points_per_cell(4), 81u); // 17 are possible
}

BOOST_AUTO_TEST_SUITE_END()
