// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Balls that touch, exactly and nearly, and balls inside others.

#include "support/large_ties.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_ball_traits_d.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Do_balls_intersect)

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Epick::Point_2;
using Point_3 = Epick::Point_3;

BOOST_AUTO_TEST_CASE(balls_that_touch)
{
  using Ball = std::pair<Point_2, double>;
  for(const Tie& tie : large_ties()) {
    const double r = std::floor(tie.c / 3), s = tie.c - r;
    const std::vector<Ball> balls = {{Point_2(0, 0), r}, {Point_2(tie.a, tie.b), s}};
    const auto do_intersect = CGAL::Thick_ball_traits_d<Point_2>(balls).do_intersect_d_object();
    BOOST_REQUIRE(do_intersect(balls[0], balls[1]));
    BOOST_REQUIRE(!do_intersect(balls[0], Ball(balls[1].first, std::nextafter(s, 0.))));
  }
  // A sum of radii that is no double, and one that overflows.
  const std::vector<Ball> balls = {{Point_2(0, 0), 1e308}, {Point_2(1.7e308, 0), 1e308}};
  const auto do_intersect = CGAL::Thick_ball_traits_d<Point_2>(balls).do_intersect_d_object();
  BOOST_CHECK(do_intersect(balls[0], balls[1]));
  const double tiny = std::ldexp(1., -60);
  BOOST_CHECK(do_intersect(Ball(Point_2(0, 0), 1), Ball(Point_2(1, 0), tiny)));
  BOOST_CHECK(!do_intersect(Ball(Point_2(0, 0), 1), Ball(Point_2(std::nextafter(1, 2.), 0), tiny)));
}

// Too long for integers, so that exact numbers decide; squares overflow, vanish, or do neither.
BOOST_AUTO_TEST_CASE(squares_of_balls_that_overflow_or_vanish)
{
  using Ball = std::pair<Point_2, double>;
  for(const double scale : {0x1p1020, 0x1p530, 1., 0x1p-530, 0x1p-565, 0x1p-900})
    for(const double rest : {0., scale * 0x1p-100}) {
      const double r = 2 * scale, s = 3 * scale;
      const Ball a(Point_2(rest, 0), r), b(Point_2(r + s, 0), s), c(Point_2(1.001 * (r + s), 0), s);
      const auto do_intersect
        = CGAL::Thick_ball_traits_d<Point_2>(std::vector<Ball>{a, b}).do_intersect_d_object();
      BOOST_CHECK(do_intersect(a, b));
      BOOST_CHECK(!do_intersect(a, c));
    }
}

BOOST_AUTO_TEST_CASE(balls_of_thirds_touch)
{
  using Number = CGAL::Exact_rational;
  using Point = CGAL::Simple_cartesian<Number>::Point_2;
  using Ball = std::pair<Point, Number>;
  const Number third = Number(1) / 3, tiny = third / 1e20;
  const Number x = third * 4, y = third * 3, r = third * 2;
  const Ball a(Point(0, 0), r), b(Point(x, y), y);
  const auto do_intersect
    = CGAL::Thick_ball_traits_d<Point>(std::vector<Ball>{a, b}).do_intersect_d_object();
  BOOST_CHECK(do_intersect(a, b));
  BOOST_CHECK(!do_intersect(a, Ball(b.first, Number(y - tiny))));
}

BOOST_AUTO_TEST_CASE(inner_balls_intersect_outer_ones)
{
  using Ball = std::pair<Point_3, double>;
  const std::vector<Ball> balls = {{Point_3(0, 0, 0), 10}, {Point_3(1, 0, 0), 1}};
  const auto do_intersect = CGAL::Thick_ball_traits_d<Point_3>(balls).do_intersect_d_object();
  BOOST_CHECK(do_intersect(balls[0], balls[1]));
  BOOST_CHECK(do_intersect(balls[0], balls[0]));
}

BOOST_AUTO_TEST_SUITE_END()
