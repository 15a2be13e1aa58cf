// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polylines and polygons on several kernels and scales, against all pairs of their segments and all
// vertices: which ones intersect, and which ones are within a distance. Thirds, and numbers that no
// double is between, have the pairs of the integers that they are multiples of.

#include "support/check_features.h"

#include <CGAL/Exact_integer.h>
#include <CGAL/Homogeneous.h>

using namespace test_support;

using Float_kernel = CGAL::Simple_cartesian<float>;
using Integer_kernel = CGAL::Simple_cartesian<long long>;
using Homogeneous_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;

BOOST_AUTO_TEST_CASE(features_of_doubles)
{
  check_feature_scenes<Features_2, Double_kernel, Epick, Float_kernel>(
    2, {Scale::ONE, Scale::HUGE_POWER, Scale::DENORMAL});
}

BOOST_AUTO_TEST_CASE(features_of_exact_numbers)
{
  check_feature_scenes<Features_2, Epeck, Rational_kernel>(2, {Scale::THIRD, Scale::CLOSE});
  check_feature_scenes<Features_2, Integer_kernel, Homogeneous_kernel>(2, {Scale::ONE});
}

BOOST_AUTO_TEST_CASE(polylines_in_space)
{
  check_feature_scenes<Features_3, Double_kernel, Epick>(3, {Scale::ONE, Scale::HUGE_POWER});
  check_feature_scenes<Features_3, Epeck, Rational_kernel>(3, {Scale::THIRD, Scale::CLOSE});
}

BOOST_AUTO_TEST_CASE(near_features_of_plain_doubles)
{
  check_near_features<Features_2, Double_kernel>(2, 4, false);
  check_near_features<Features_3, Double_kernel>(3, 5, true);
}

BOOST_AUTO_TEST_CASE(near_features_of_exact_numbers)
{
  check_near_features<Features_2, Epeck, Rational_kernel>(2, 2, true);
  check_near_features<Features_2, Epeck, Rational_kernel>(2, 5, false,
                                                          {Scale::THIRD, Scale::CLOSE});
  check_near_features<Features_2, Epeck, Rational_kernel>(2, 5, true, {Scale::THIRD, Scale::CLOSE});
}

BOOST_AUTO_TEST_CASE(near_polylines_in_space_of_exact_numbers)
{
  check_near_features<Features_3, Epeck, Rational_kernel>(
    3, 5, false, {Scale::ONE, Scale::THIRD, Scale::CLOSE});
}
