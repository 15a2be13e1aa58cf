// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes in kernels for points of any dimension.

#include "support/check_fuzz.h"

#include <CGAL/Epeck_d.h>
#include <CGAL/Epick_d.h>

using namespace test_support;

using Epeck = CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>;
using Epick = CGAL::Epick_d<CGAL::Dynamic_dimension_tag>;

BOOST_AUTO_TEST_CASE(epick_2)
{
  fuzz<Fuzz_points_d<Epick, 2, false>, NEAR_PAIRS | CLOSEST_PAIRS>(20000);
}
BOOST_AUTO_TEST_CASE(epick_3)
{
  fuzz<Fuzz_points_d<Epick, 3, false>, NEAR_PAIRS | CLOSEST_PAIRS>(20000);
}
BOOST_AUTO_TEST_CASE(epeck_2)
{
  fuzz<Fuzz_points_d<Epeck, 2, true>, NEAR_PAIRS | BALLS>(5000);
}
BOOST_AUTO_TEST_CASE(epeck_3)
{
  fuzz<Fuzz_points_d<Epeck, 3, true>, NEAR_PAIRS | CLOSEST_PAIRS>(5000);
}
BOOST_AUTO_TEST_CASE(epeck_of_fixed_dimension_3)
{
  using Static = CGAL::Epeck_d<CGAL::Dimension_tag<3>>;
  fuzz<Fuzz_points_d<Static, 3, true>, NEAR_PAIRS | CLOSEST_PAIRS>(2000);
}
