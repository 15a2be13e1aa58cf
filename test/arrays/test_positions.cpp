// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Positions of 32 bits, one of which stands for none.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

BOOST_AUTO_TEST_SUITE(positions)

using namespace test_support;

BOOST_AUTO_TEST_CASE(more_points_than_positions_are_refused)
{
  BOOST_CHECK_NO_THROW(internal::check_size(0));
  BOOST_CHECK_NO_THROW(internal::check_size(0xfffffffe));
  BOOST_CHECK_THROW(internal::check_size(0xffffffff), std::length_error);
  if constexpr(sizeof(std::size_t) > 4)
    BOOST_CHECK_THROW(internal::check_size(std::size_t(0xffffffff) + 1), std::length_error);
}

BOOST_AUTO_TEST_SUITE_END()
