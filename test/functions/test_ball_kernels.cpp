// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of balls of all sizes and magnitudes, in sequence and in parallel, and on the kernels that
// other tests of balls leave out.

#include "support/check_balls.h"
#include "support/kernels.h"

#include <CGAL/Epick_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Homogeneous.h>

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Static_points = Points_d<CGAL::Epick_d<CGAL::Dimension_tag<Dimension>>>;
using Dynamic_points = Points_d<CGAL::Epick_d<CGAL::Dynamic_dimension_tag>>;
using Integer_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;

namespace {

// Sums of squares overflow, underflow, or are no doubles.
const double units[] = {1, 0.1, 1e300, 5e-324};

} // namespace

BOOST_AUTO_TEST_CASE(balls_epick_3)
{
  for(const double unit : units)
    check_ball_scenes<Cartesian_points<Epick, 3>, double, CGAL::Sequential_tag,
                      CGAL::Parallel_tag>(3, unit);
}

BOOST_AUTO_TEST_CASE(balls_epick_d)
{
  for(const double unit : units) {
    check_ball_scenes<Static_points<2>, double, CGAL::Sequential_tag>(2, unit);
    check_ball_scenes<Static_points<5>, double, CGAL::Sequential_tag>(5, unit);
  }
}

BOOST_AUTO_TEST_CASE(balls_epick_d_of_dynamic_dimension)
{
  for(const int dimension : {2, 3, 5})
    check_ball_scenes<Dynamic_points, double, CGAL::Sequential_tag>(dimension, 0.1);
}

BOOST_AUTO_TEST_CASE(balls_homogeneous)
{
  check_ball_scenes<Homogeneous_points<Integer_kernel, 2>, Integer_kernel::FT,
                    CGAL::Sequential_tag>(2, 1);
}
