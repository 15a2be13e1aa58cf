// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random scenes whose coordinates are thirds, in exact numbers.

#include "support/check_fuzz.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Simple_cartesian.h>

using namespace test_support;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rationals = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Integers = CGAL::Homogeneous<CGAL::Exact_integer>;

BOOST_AUTO_TEST_CASE(epeck_3) { fuzz<Fuzz_cartesian<Epeck, 3, true>, NEAR_PAIRS | BALLS>(20000); }
BOOST_AUTO_TEST_CASE(rationals_2)
{
  fuzz<Fuzz_cartesian<Rationals, 2, true>, NEAR_PAIRS | CLOSEST_PAIRS>(20000);
}
BOOST_AUTO_TEST_CASE(homogeneous_2)
{
  fuzz<Fuzz_homogeneous<Integers, 2>, NEAR_PAIRS | CLOSEST_PAIRS>(2000);
}

// Near pairs at the limits of narrow coordinates.
BOOST_AUTO_TEST_CASE(partners_of_epeck_3) { fuzz<Fuzz_cartesian<Epeck, 3, true>, PARTNERS>(5000); }
BOOST_AUTO_TEST_CASE(partners_of_rationals_2)
{
  fuzz<Fuzz_cartesian<Rationals, 2, true>, PARTNERS>(5000);
}
