// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of balls of all sizes and magnitudes, in sequence and in parallel, on all kernels: against
// all pairs tested in exact rational numbers.

#include "support/check_balls.h"
#include "support/kernels.h"
#include "support/usual_kernels.h"

#include <CGAL/Epick_d.h>
#include <CGAL/Homogeneous.h>

#include <limits>

using namespace test_support;

using Integer_kernel = CGAL::Homogeneous<CGAL::Exact_integer>;
using Homogeneous_balls = Balls_of<Homogeneous_points<Integer_kernel, 2>, Integer_kernel::FT>;

namespace {

template <class Kernel, int Dimension, class... ConcurrencyTags>
using Balls_on = Balls_of<Cartesian_points<Kernel, Dimension>, typename Kernel::FT,
                          ConcurrencyTags...>;
template <int Dimension>
using Static_balls = Balls_of<Points_d<CGAL::Epick_d<CGAL::Dimension_tag<Dimension>>>>;
using Dynamic_balls = Balls_of<Points_d<CGAL::Epick_d<CGAL::Dynamic_dimension_tag>>>;

template <int Dimension>
void check_on_usual_kernels(double unit)
{
  const std::size_t tangent
    = check_ball_scenes<Balls_on<Epick, Dimension, CGAL::Parallel_tag>,
                        Balls_on<Double_kernel, Dimension>, Balls_on<Epeck, Dimension>,
                        Balls_on<Rational_kernel, Dimension>>(Dimension, unit);
  BOOST_CHECK_GT(tangent, unit == 1 ? 40u : 0u);
}

// Sums of squares overflow, underflow, or are no doubles.
const double units[] = {1, 0.1, 1e-170, 1e170, 1e300, 5e-324};

} // namespace

BOOST_AUTO_TEST_CASE(balls_on_usual_kernels)
{
  for(const double unit : units) {
    check_on_usual_kernels<2>(unit);
    check_on_usual_kernels<3>(unit);
  }
}

BOOST_AUTO_TEST_CASE(balls_of_any_dimension)
{
  for(const double unit : units) {
    check_ball_scenes<Static_balls<2>, Dynamic_balls>(2, unit);
    check_ball_scenes<Static_balls<5>, Dynamic_balls>(5, unit);
  }
  check_ball_scenes<Dynamic_balls>(3, 0.1);
}

BOOST_AUTO_TEST_CASE(balls_of_quotients) { check_ball_scenes<Homogeneous_balls>(2, 1); }

// The diameter is no double, nor its square.
BOOST_AUTO_TEST_CASE(balls_of_one_radius_beyond_all_doubles)
{
  const double radius = 1.5e308;
  const std::vector<std::pair<Epick::Point_2, double>> balls
    = {{Epick::Point_2(-1.5e308, 0), radius}, {Epick::Point_2(1.5e308, 0), radius},
       {Epick::Point_2(1.5e308, 5e-324), radius}};
  check_pairs("balls", {{0, 1}, {1, 2}}, reported([&](auto collect) {
    CGAL::thick_self_intersection_d(
      balls, collect,
      CGAL::parameters::geom_traits(CGAL::Thick_ball_traits_d<Epick::Point_2>(balls)));
  }));
}

BOOST_AUTO_TEST_CASE(bad_radii_are_refused_by_position)
{
  using Ball = std::pair<Epick::Point_2, double>;
  for(const double bad : {-1., std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity()}) {
    const std::vector<Ball> balls = {{Epick::Point_2(0, 0), 1}, {Epick::Point_2(0, 0), bad}};
    const CGAL::Thick_ball_traits_d<Epick::Point_2> traits(balls);
    BOOST_CHECK(contains(refusal([&] {
      CGAL::thick_self_intersection_d(balls, [](std::size_t, std::size_t) {},
                                      CGAL::parameters::geom_traits(traits));
    }), "object 1"));
  }
}
