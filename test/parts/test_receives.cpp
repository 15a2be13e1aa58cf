// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which of two parts receives the points of the other.

#include <CGAL/Thick_intersection_d/internal/parts/receives.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(receives)

namespace internal = CGAL::Thick_intersection_d::internal;

BOOST_AUTO_TEST_CASE(exactly_one_of_two_parts_receives)
{
  for(int a = 0; a < 40; ++a)
    for(int b = 0; b < 40; ++b)
      BOOST_CHECK_EQUAL(internal::receives(a, b) + internal::receives(b, a), a != b);
}

BOOST_AUTO_TEST_CASE(a_part_receives_from_half_of_the_others)
{
  for(const int count : {2, 7, 40})
    for(int a = 0; a < count; ++a) {
      int others = 0;
      for(int b = 0; b < count; ++b)
        others += internal::receives(a, b);
      BOOST_CHECK_GE(others, (count - 1) / 2 - (count % 2 == 0));
      BOOST_CHECK_LE(others, count / 2);
    }
}

BOOST_AUTO_TEST_SUITE_END()
