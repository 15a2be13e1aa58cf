// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tetrahedra, degenerate or not, against the oracle.

#include "support/check_simplices.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(tetrahedra)

using test_support::check_simplices;

BOOST_AUTO_TEST_CASE(triangle_and_tetrahedron) { check_simplices<3, 3, 4>(20000); }
BOOST_AUTO_TEST_CASE(tetrahedra) { check_simplices<3, 4, 4>(20000); }

BOOST_AUTO_TEST_SUITE_END()
