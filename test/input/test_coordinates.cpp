// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points are checked one by one, so a check costs nothing but comparisons unless it fails.

#include "support/counting_allocator.h"
#include "support/error_messages.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <CGAL/Simple_cartesian.h>

BOOST_AUTO_TEST_SUITE(coordinates)

using namespace test_support;
using Point = CGAL::Simple_cartesian<double>::Point_2;

constexpr const char* name = "vertex of object"; // with a position, too long for a small string

BOOST_AUTO_TEST_CASE(checking_a_good_point_takes_no_memory)
{
  const Point point(1, 2);
  const Memory_that_runs_out memory(0);
  BOOST_CHECK_NO_THROW(internal::check_point(point, 2, name, 7));
}

BOOST_AUTO_TEST_CASE(error_names_the_point_and_the_axis)
{
  const auto message_about = [](const Point& point, int dimension) {
    return error_message([&] { internal::check_point(point, dimension, name, 7); });
  };
  BOOST_CHECK_EQUAL(message_about(Point(0, infinity), 2),
                    "Coordinate 1 of vertex of object 7 is NaN or infinite.");
  BOOST_CHECK_EQUAL(message_about(Point(0, 0), 3),
                    "vertex of object 7 has dimension 2 instead of 3.");
}

BOOST_AUTO_TEST_SUITE_END()
