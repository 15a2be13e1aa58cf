// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments and triangles in the plane, degenerate or not, against the oracle.

#include "support/check_simplices.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(planar_objects)

using test_support::check_simplices;

BOOST_AUTO_TEST_CASE(segments) { check_simplices<2, 2, 2>(60000); }
BOOST_AUTO_TEST_CASE(segment_and_triangle) { check_simplices<2, 2, 3>(60000); }
BOOST_AUTO_TEST_CASE(triangles) { check_simplices<2, 3, 3>(60000); }

BOOST_AUTO_TEST_SUITE_END()
