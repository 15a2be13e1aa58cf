// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments, triangles, boxes, tetrahedra and balls of small random scenes by each route, on all
// kinds of kernels.

#include "support/check_fuzz.h"
#include "support/usual_kernels.h"

#include <CGAL/Epick_d.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Simple_homogeneous.h>

using namespace test_support;

using Filtered_doubles = CGAL::Filtered_kernel<Double_kernel>;
using Filtered_rationals = CGAL::Filtered_kernel<Rational_kernel>;
using Floats = CGAL::Simple_cartesian<float>;
using Homogeneous = CGAL::Homogeneous<CGAL::Exact_integer>;
using Integers = CGAL::Simple_cartesian<long long>;
using Long_doubles = CGAL::Simple_cartesian<long double>;
using Simple_homogeneous = CGAL::Simple_homogeneous<CGAL::Exact_integer>;

namespace {

template <class Maker>
void fuzz_objects(std::uint64_t count)
{
  fuzz<Maker, OBJECTS | ROUTES>(count);
}

template <class Maker>
void fuzz_balls(std::uint64_t count)
{
  fuzz<Maker, BALLS | ROUTES>(count);
}

template <int Dimension>
using Static_points
  = Fuzz_points_d<CGAL::Epick_d<CGAL::Dimension_tag<Dimension>>, Dimension, false>;
template <int Dimension>
using Dynamic_points
  = Fuzz_points_d<CGAL::Epick_d<CGAL::Dynamic_dimension_tag>, Dimension, false>;

} // namespace

BOOST_AUTO_TEST_CASE(objects_of_floating_numbers)
{
  fuzz_objects<Fuzz_cartesian<Double_kernel, 2, false>>(20000);
  fuzz_objects<Fuzz_cartesian<Double_kernel, 3, false>>(20000);
  fuzz_objects<Fuzz_cartesian<Epick, 2, false>>(20000);
  fuzz_objects<Fuzz_cartesian<Filtered_doubles, 2, false>>(5000);
  fuzz_objects<Fuzz_cartesian<Filtered_doubles, 3, false>>(5000);
  fuzz_objects<Fuzz_cartesian<Floats, 2, false>>(20000);
  fuzz_objects<Fuzz_cartesian<Long_doubles, 2, false>>(5000);
}

BOOST_AUTO_TEST_CASE(objects_of_exact_numbers)
{
  fuzz_objects<Fuzz_cartesian<Epeck, 2, true>>(2000);
  fuzz_objects<Fuzz_cartesian<Epeck, 3, true>>(2000);
  fuzz_objects<Fuzz_cartesian<Rational_kernel, 2, true>>(2000);
  fuzz_objects<Fuzz_cartesian<Filtered_rationals, 2, true>>(1000);
  fuzz_objects<Fuzz_cartesian<Filtered_rationals, 3, true>>(1000);
}

BOOST_AUTO_TEST_CASE(objects_that_no_double_is_between)
{
  fuzz_objects<Fuzz_close<Epeck, 2>>(1000);
  fuzz_objects<Fuzz_close<Rational_kernel, 2>>(1000);
}

BOOST_AUTO_TEST_CASE(objects_of_integers)
{
  fuzz_objects<Fuzz_cartesian<Integers, 2, false>>(20000);
  fuzz_objects<Fuzz_homogeneous<Homogeneous, 2>>(1000);
  fuzz_objects<Fuzz_homogeneous<Homogeneous, 3>>(1000);
  fuzz_objects<Fuzz_homogeneous<Simple_homogeneous, 2>>(1000);
}

BOOST_AUTO_TEST_CASE(balls_of_all_kernels)
{
  fuzz_balls<Fuzz_cartesian<Double_kernel, 2, false>>(20000);
  fuzz_balls<Fuzz_cartesian<Epick, 3, false>>(20000);
  fuzz_balls<Fuzz_cartesian<Epeck, 2, true>>(1000);
  fuzz_balls<Fuzz_cartesian<Rational_kernel, 3, true>>(1000);
  fuzz_balls<Fuzz_homogeneous<Homogeneous, 2>>(300);
}

BOOST_AUTO_TEST_CASE(balls_of_any_dimension)
{
  fuzz_balls<Static_points<2>>(10000);
  fuzz_balls<Static_points<5>>(10000);
  fuzz_balls<Dynamic_points<3>>(10000);
  fuzz_balls<Dynamic_points<5>>(10000);
}

// The diameter is no double, nor its square.
BOOST_AUTO_TEST_CASE(balls_of_one_radius_beyond_all_doubles)
{
  const double radius = 1.5e308;
  const std::vector<std::pair<Epick::Point_2, double>> balls
    = {{Epick::Point_2(-1.5e308, 0), radius}, {Epick::Point_2(1.5e308, 0), radius},
       {Epick::Point_2(1.5e308, 5e-324), radius}};
  const CGAL::Thick_ball_traits_d<Epick::Point_2> traits(balls);
  BOOST_CHECK(sorted(reported([&](auto collect) {
    CGAL::thick_self_intersection_d(balls, collect, CGAL::parameters::geom_traits(traits));
  })) == (Pairs{{0, 1}, {1, 2}}));
}
