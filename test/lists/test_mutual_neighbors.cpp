// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(mutual_neighbors)

BOOST_AUTO_TEST_CASE(pairs_in_one_of_their_lists_are_left_out)
{
  const CGAL::Neighbor_lists lists({0, 3, 4, 5, 7}, {1, 2, 3, 0, 3, 0, 1});
  const CGAL::Neighbor_lists mutual({0, 2, 3, 3, 4}, {1, 3, 0, 0});
  BOOST_CHECK(CGAL::Thick_intersection_d::internal::mutual_neighbors(lists) == mutual);
  BOOST_CHECK(CGAL::Thick_intersection_d::internal::mutual_neighbors(mutual) == mutual);
}

BOOST_AUTO_TEST_SUITE_END()
