// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Interiors of polygons on several kernels and scales, against points between all of their edges.

#include "support/check_interiors.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/Homogeneous.h>

using namespace test_support;

using Integer_kernel = CGAL::Simple_cartesian<CGAL::Exact_integer>; // without division
using Homogeneous_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;

BOOST_AUTO_TEST_CASE(interiors_of_plain_doubles)
{
  check_interior_scenes<Double_kernel>(1, 60, 8, {Scale::ONE, Scale::HUGE_POWER, Scale::DENORMAL});
}

BOOST_AUTO_TEST_CASE(interiors_of_exact_numbers)
{
  check_interior_scenes<Epeck, Rational_kernel>(2, 30, 8, {Scale::THIRD, Scale::CLOSE});
}

BOOST_AUTO_TEST_CASE(interiors_of_integers)
{
  check_interior_scenes<Integer_kernel, Homogeneous_kernel>(3, 12, 8, {Scale::ONE});
}
