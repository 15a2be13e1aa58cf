// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Every scene on the kernels whose coordinates are floating numbers: float, double, any precision.

#include "support/check_kernel.h"
#include "support/mpfr_kernel_number.h"

using namespace test_support;

using Float_kernel = CGAL::Simple_cartesian<float>;
using Mpfr_kernel = CGAL::Simple_cartesian<Mpfr_number<30>>; // decimal digits: 53 bits fit

BOOST_AUTO_TEST_CASE(epick_2) { check_kernel<Cartesian_points<Epick, 2>>(2); }
BOOST_AUTO_TEST_CASE(epick_3) { check_kernel<Cartesian_points<Epick, 3>>(3); }
BOOST_AUTO_TEST_CASE(double_2) { check_kernel<Cartesian_points<Double_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(double_3) { check_kernel<Cartesian_points<Double_kernel, 3>>(3); }
BOOST_AUTO_TEST_CASE(mpfr_2) { check_kernel<Cartesian_points<Mpfr_kernel, 2>>(2); }
BOOST_AUTO_TEST_CASE(mpfr_3) { check_kernel<Cartesian_points<Mpfr_kernel, 3>>(3); }

// Bits of the mantissa are less than the least double.
BOOST_AUTO_TEST_CASE(numbers_of_more_bits_than_doubles_have_exponents)
{
  using Number = Mpfr_number<400>;
  using Point = CGAL::Simple_cartesian<Number>::Point_2;
  const Number third = Number(1) / 3;
  const std::vector<Point> points = {{Number(0), Number(0)}, {third, Number(0)}};
  const auto bound = CGAL::within_distance(third);
  Pairs pairs;
  CGAL::fixed_radius_near_neighbors(points, bound, std::back_inserter(pairs));
  check_pairs("at the distance", {{0, 1}}, pairs);
  pairs.clear();
  CGAL::fixed_radius_near_neighbors(points, bound.open(), std::back_inserter(pairs));
  check_pairs("closer", {}, pairs);
}

BOOST_AUTO_TEST_CASE(float_2)
{
  check_scenes<Cartesian_points<Float_kernel, 2>>(float_scenes(2));
}

BOOST_AUTO_TEST_CASE(float_3)
{
  check_scenes<Cartesian_points<Float_kernel, 3>>(float_scenes(3));
}
