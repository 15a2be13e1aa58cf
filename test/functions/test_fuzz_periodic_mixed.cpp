// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Small random periodic scenes on further kernels, and of points and domains of different kernels.

#include "support/check_periodic_fuzz.h"
#include "support/usual_kernels.h"

#include <CGAL/Epick_d.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Homogeneous.h>

using namespace test_support;

using Floats = CGAL::Simple_cartesian<float>;
using Integers = CGAL::Homogeneous<CGAL::Exact_integer>;

BOOST_AUTO_TEST_CASE(floats_3) { fuzz_periodic<Fuzz_cartesian<Floats, 3, false>>(2000); }
BOOST_AUTO_TEST_CASE(homogeneous_2) { fuzz_periodic<Fuzz_homogeneous<Integers, 2>>(200); }

// Points are doubles, and periods thirds.
BOOST_AUTO_TEST_CASE(doubles_in_a_domain_of_rationals_3)
{
  fuzz_periodic<Fuzz_cartesian<Epick, 3, false>, Fuzz_cartesian<Rational_kernel, 3, true>>(400);
}

// Points are thirds, and periods doubles.
BOOST_AUTO_TEST_CASE(rationals_in_a_domain_of_doubles_2)
{
  fuzz_periodic<Fuzz_cartesian<Rational_kernel, 2, true>, Fuzz_cartesian<Epick, 2, false>>(400);
}

BOOST_AUTO_TEST_CASE(epick_d_3)
{
  using Epick_3 = CGAL::Epick_d<CGAL::Dimension_tag<3>>;
  fuzz_periodic<Fuzz_points_d<Epick_3, 3, false>, Fuzz_cartesian<Epick, 3, false>>(400);
}
