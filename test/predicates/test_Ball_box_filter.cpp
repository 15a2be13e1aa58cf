// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the boxes of two balls tell, against integers of any length: near ties at all scales and far
// from the origin, in every rounding mode.

#include "support/exact_points.h"
#include "support/point_generators.h"
#include "support/rounding_mode.h"

#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Do_balls_intersect.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

BOOST_AUTO_TEST_SUITE(Ball_box_filter)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

// A ball in steps of a grid: integers, as doubles.
template <std::size_t Dimension>
struct Ball
{
  std::array<double, Dimension> center;
  double radius;

  // As ball_interval() has it, on a grid of 2^exponent.
  std::array<internal::Interval, Dimension> box(int exponent) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<internal::Interval, Dimension> box;
    for(std::size_t i = 0; i < Dimension; ++i) {
      const double c = std::ldexp(center[i], exponent), r = std::ldexp(radius, exponent);
      box[i] = {std::nextafter(c - r, -infinity), std::nextafter(c + r, infinity)};
    }
    return box;
  }
};

template <std::size_t Dimension>
Integer squared_distance(const Ball<Dimension>& a, const Ball<Dimension>& b)
{
  Integer sum = 0;
  for(std::size_t i = 0; i < Dimension; ++i) {
    const Integer gap = Integer(a.center[i]) - Integer(b.center[i]);
    sum += gap * gap;
  }
  return sum;
}

template <std::size_t Dimension>
bool do_intersect_exactly(const Ball<Dimension>& a, const Ball<Dimension>& b)
{
  const Integer radii = Integer(a.radius) + Integer(b.radius);
  return squared_distance(a, b) <= radii * radii;
}

// Centers with coordinates of up to `bits` bits, and `offset` from the origin. The sum of the radii
// is the distance times 1 + 2^-closeness, up to one step, or that times 1 - 2^-closeness.
template <std::size_t Dimension>
std::pair<Ball<Dimension>, Ball<Dimension>> near_tie(int bits, double offset, int closeness,
                                                     Random& random)
{
  std::pair<Ball<Dimension>, Ball<Dimension>> balls;
  auto& [a, b] = balls;
  for(std::size_t i = 0; i < Dimension; ++i)
    for(Ball<Dimension>* ball : {&a, &b})
      ball->center[i] = offset + static_cast<double>(random.below(std::uint64_t(1) << bits));
  const double distance = std::sqrt(static_cast<double>(squared_distance(a, b)));
  const double sign = random.below(2) == 0 ? 1 : -1;
  const double radii = std::floor(distance * (1 + sign * std::ldexp(1., -closeness)))
                       + static_cast<double>(random.below(2));
  a.radius = std::floor(radii * 0.375);
  b.radius = radii - a.radius;
  return balls;
}

// Returns the share of the answers that are certain.
template <std::size_t Dimension>
double check_near_ties(int bits, double offset, int closeness, int exponent)
{
  const int count = 300;
  int certain = 0;
  Random random(static_cast<unsigned int>(bits + closeness));
  for(int k = 0; k < count; ++k) {
    const auto [a, b] = near_tie<Dimension>(bits, offset, closeness, random);
    const bool expected = do_intersect_exactly(a, b);
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      const CGAL::Uncertain<bool> found
        = internal::Ball_box_filter::do_intersect(a.box(exponent), b.box(exponent));
      if(CGAL::is_certain(found) && CGAL::get_certain(found) != expected)
        BOOST_ERROR(bits << " bits, offset " << offset << ", closeness " << closeness
                         << ", grid 2^" << exponent << ": balls that "
                         << (expected ? "intersect" : "do not intersect"));
      certain += CGAL::is_certain(found);
    }
  }
  return certain / (4. * count);
}

template <std::size_t Dimension>
void check_all_near_ties()
{
  for(const int bits : {2, 4, 7, 20, 40, 51})
    for(const double offset : {0., 0x1p40, 0x1p53 - std::ldexp(1., bits)}) // ends are rounded
      for(const int closeness : {1, 3, 5, 20, 40, 44, 45, 46, 47, 48, 50, 52})
        for(const int exponent : {-1074, -540, -530, -500, -400, 0, 400, 460, 490, 900, 970})
          check_near_ties<Dimension>(bits, offset, closeness, exponent);
}

BOOST_AUTO_TEST_CASE(what_is_certain_is_right)
{
  check_all_near_ties<2>();
  check_all_near_ties<3>();
  check_all_near_ties<8>();
}

BOOST_AUTO_TEST_CASE(balls_that_are_no_near_tie_are_certain)
{
  BOOST_CHECK_EQUAL(check_near_ties<2>(40, 0, 30, 0), 1);
  BOOST_CHECK_EQUAL(check_near_ties<3>(40, 0, 30, -400), 1);
  BOOST_CHECK_EQUAL(check_near_ties<8>(40, 0, 30, 400), 1);
  BOOST_CHECK_LT(check_near_ties<3>(51, 0, 52, 0), .1);
}

// The filter relies on it.
BOOST_AUTO_TEST_CASE(ends_of_boxes_are_off_by_at_most_two_steps)
{
  using Point = CGAL::Simple_cartesian<double>::Point_2;
  using Rational = CGAL::Exact_rational;
  Random random(7);
  for(int k = 0; k < 1000; ++k) {
    const double center = random.uniform() - .5, radius = std::ldexp(random.uniform(), -k % 60);
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      const auto [low, high] = internal::ball_interval(std::make_pair(Point(center, 0), radius), 0);
      const Rational step(std::numeric_limits<double>::epsilon()
                          * (std::max)(std::fabs(low), std::fabs(high)));
      const Rational low_error(Rational(center) - Rational(radius) - Rational(low));
      const Rational high_error(Rational(high) - Rational(center) - Rational(radius));
      BOOST_CHECK(low_error >= 0 && low_error <= 2 * step);
      BOOST_CHECK(high_error >= 0 && high_error <= 2 * step);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
