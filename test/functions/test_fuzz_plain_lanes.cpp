// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes by the plain lanes: the folder support/plain_lanes comes first in the search
// for headers, and has no others. Floats take them too.

#include "support/check_fuzz.h"

using namespace test_support;

using Doubles = CGAL::Simple_cartesian<double>;
using Floats = CGAL::Simple_cartesian<float>;

BOOST_AUTO_TEST_CASE(plain_lanes_are_taken)
{
  internal::with_lanes([](auto set) {
    BOOST_CHECK((std::is_same_v<decltype(set), internal::lanes_plain::Lanes>));
  });
}

BOOST_AUTO_TEST_CASE(doubles_2)
{
  fuzz<Fuzz_cartesian<Doubles, 2, false>, NEAR_PAIRS | OBJECTS>(100000);
}
BOOST_AUTO_TEST_CASE(floats_3)
{
  fuzz<Fuzz_cartesian<Floats, 3, false>, NEAR_PAIRS | CLOSEST_PAIRS>(100000);
}
