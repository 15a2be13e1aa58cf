// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Balls with individual radii, on the kernels: against all pairs tested in exact rational numbers.

#include "support/check_balls.h"
#include "support/kernels.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/thick_intersection_d.h>

#include <boost/test/unit_test.hpp>

#include <random>

using namespace test_support;

using Double_kernel = CGAL::Simple_cartesian<double>;
using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

namespace {

template <int Dimension>
Number_balls random_balls(double unit, std::size_t radii)
{
  std::mt19937_64 random(19);
  Number_balls balls;
  for(int i = 0; i < 300; ++i) {
    Coordinates c;
    for(int k = 0; k < Dimension; ++k)
      c.push_back(unit * (static_cast<double>(random() % (Dimension == 2 ? 40 : 16)) - 8));
    balls.push_back({c, unit * static_cast<double>(radii == 1 ? 2 : random() % radii)});
  }
  return balls;
}

template <class Maker, class Kernel>
void check_balls(const Number_balls& balls, const Pairs& expected)
{
  using Ball = std::pair<typename Maker::Point, typename Kernel::FT>;
  std::vector<Ball> objects;
  for(const Number_ball& ball : balls)
    objects.emplace_back(Maker::make(ball.center), typename Kernel::FT(ball.radius));
  check_ball_pairs<CGAL::Sequential_tag>(objects, expected);
}

template <int Dimension>
void check_balls_on_kernels(std::size_t radii)
{
  for(const double unit : {1., 0.1, 1e-170, 1e170}) {
    const Number_balls balls = random_balls<Dimension>(unit, radii);
    Pairs expected;
    std::size_t tangent = 0;
    for(std::size_t i = 0; i < balls.size(); ++i)
      for(std::size_t j = i + 1; j < balls.size(); ++j) {
        const int sign = compare_distance_with_radii(balls[i], balls[j]);
        if(sign <= 0)
          expected.emplace_back(i, j);
        tangent += sign == 0;
      }
    BOOST_CHECK_GT(tangent, unit == 1 ? 40u : 0u);
    check_balls<Cartesian_points<Double_kernel, Dimension>, Double_kernel>(balls, expected);
    check_balls<Cartesian_points<Epick, Dimension>, Epick>(balls, expected);
    check_balls<Cartesian_points<Epeck, Dimension>, Epeck>(balls, expected);
    check_balls<Cartesian_points<Rational_kernel, Dimension>, Rational_kernel>(balls, expected);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(balls_2) { check_balls_on_kernels<2>(6); }
BOOST_AUTO_TEST_CASE(balls_3) { check_balls_on_kernels<3>(6); }
BOOST_AUTO_TEST_CASE(balls_of_one_radius_2) { check_balls_on_kernels<2>(1); }
BOOST_AUTO_TEST_CASE(balls_of_one_radius_3) { check_balls_on_kernels<3>(1); }

// The diameter is no double, nor its square.
BOOST_AUTO_TEST_CASE(balls_of_one_radius_beyond_all_doubles)
{
  const double radius = 1.5e308;
  const std::vector<std::pair<Epick::Point_2, double>> balls
    = {{Epick::Point_2(-1.5e308, 0), radius}, {Epick::Point_2(1.5e308, 0), radius},
       {Epick::Point_2(1.5e308, 5e-324), radius}};
  Pairs pairs;
  CGAL::thick_self_intersection_d(
    balls, [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); },
    CGAL::parameters::geom_traits(CGAL::Thick_ball_traits_d<Epick::Point_2>(balls)));
  BOOST_CHECK(sorted(pairs) == (Pairs{{0, 1}, {1, 2}}));
}

BOOST_AUTO_TEST_CASE(bad_radii_are_refused_by_position)
{
  using Ball = std::pair<Epick::Point_2, double>;
  for(const double bad : {-1., std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity()}) {
    const std::vector<Ball> balls = {{Epick::Point_2(0, 0), 1}, {Epick::Point_2(0, 0), bad}};
    const CGAL::Thick_ball_traits_d<Epick::Point_2> traits(balls);
    BOOST_CHECK_EXCEPTION(
      CGAL::thick_self_intersection_d(balls, [](std::size_t, std::size_t) {},
                                      CGAL::parameters::geom_traits(traits)),
      std::invalid_argument, [](const std::invalid_argument& error) {
        return std::string(error.what()).find("object 1") != std::string::npos;
      });
  }
}
