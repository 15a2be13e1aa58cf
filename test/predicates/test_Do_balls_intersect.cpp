// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Balls that touch, exactly and nearly, by the predicate, by the filter of their boxes, and in
// integers. Near ties at all scales, in every rounding mode, are compared with integers of any
// length. Scenes of balls are in functions/test_thick_balls.cpp.

#include "support/exact_points.h"
#include "support/plain_points.h"
#include "support/rounding_mode.h"
#include "support/squared_distance.h"
#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/Thick_ball_traits_d.h>

BOOST_AUTO_TEST_SUITE(Do_balls_intersect)

using namespace test_support;

using Point_2 = Epick::Point_2;
using Ball_2 = std::pair<Point_2, double>;

// ---- the predicate ------------------------------------------------------------------------------

template <class Point, class Number>
bool do_intersect(const std::pair<Point, Number>& a, const std::pair<Point, Number>& b)
{
  const std::vector<std::pair<Point, Number>> balls = {a, b};
  return CGAL::Thick_ball_traits_d<Point>(balls).do_intersect_d_object()(a, b);
}

// That is no double, or one that overflows.
BOOST_AUTO_TEST_CASE(sum_of_radii_is_exact)
{
  const Ball_2 unit(Point_2(0, 0), 1), huge(Point_2(0, 0), 1e308);
  const double tiny = std::ldexp(1., -60);
  BOOST_CHECK(do_intersect(huge, Ball_2(Point_2(1.7e308, 0), 1e308)));
  BOOST_CHECK(do_intersect(unit, Ball_2(Point_2(1, 0), tiny)));
  BOOST_CHECK(!do_intersect(unit, Ball_2(Point_2(std::nextafter(1, 2.), 0), tiny)));
}

BOOST_AUTO_TEST_CASE(balls_of_thirds_touch)
{
  using Number = CGAL::Exact_rational;
  using Point = CGAL::Simple_cartesian<Number>::Point_2;
  using Ball = std::pair<Point, Number>;
  const Number third = Number(1) / 3, tiny = third / 1e20;
  const Number x = third * 4, y = third * 3, r = third * 2;
  const Ball a(Point(0, 0), r), b(Point(x, y), y);
  BOOST_CHECK(do_intersect(a, b));
  BOOST_CHECK(!do_intersect(a, Ball(b.first, Number(y - tiny))));
}

// ---- near ties ----------------------------------------------------------------------------------

// A ball in steps of a grid: integers, as doubles.
template <std::size_t Dimension>
struct Ball
{
  // As ball_interval() has it, on a grid of 2^exponent.
  std::array<internal::Interval, Dimension> box(int exponent) const
  {
    std::array<internal::Interval, Dimension> box;
    for(std::size_t i = 0; i < Dimension; ++i) {
      const double c = std::ldexp(center[i], exponent), r = std::ldexp(radius, exponent);
      box[i] = {std::nextafter(c - r, -infinity), std::nextafter(c + r, infinity)};
    }
    return box;
  }

  std::array<double, Dimension> center = {};
  double radius = 0;
};

template <std::size_t Dimension>
using Two_balls = std::pair<Ball<Dimension>, Ball<Dimension>>;

template <std::size_t Dimension>
bool do_intersect_exactly(const Two_balls<Dimension>& balls)
{
  const Integer radii = Integer(balls.first.radius) + Integer(balls.second.radius);
  return squared_distance<Integer>(balls.first.center, balls.second.center) <= radii * radii;
}

// Centers with coordinates of up to `bits` bits, `offset` from the origin, along the first axes,
// and equal ones along half of these. The sum of the radii is the distance times 1 + 2^-closeness,
// up to one step, or that times 1 - 2^-closeness.
template <std::size_t Dimension>
Two_balls<Dimension> near_tie(int bits, double offset, int closeness, Random& random,
                              std::size_t dimension = Dimension)
{
  Two_balls<Dimension> balls;
  auto& [a, b] = balls;
  const auto coordinate
    = [&] { return offset + static_cast<double>(random.below(std::uint64_t(1) << bits)); };
  for(std::size_t i = 0; i < dimension; ++i) {
    a.center[i] = coordinate();
    b.center[i] = i > 0 && random.below(2) == 0 ? a.center[i] : coordinate();
  }
  const Integer square = squared_distance<Integer>(a.center, b.center);
  const double sign = random.below(2) == 0 ? 1 : -1;
  const double sum = std::floor(std::sqrt(static_cast<double>(square))
                                * (1 + sign * std::ldexp(1., -closeness)))
                     + static_cast<double>(random.below(2));
  a.radius = std::floor((std::max)(sum, 0.) * 0.375);
  b.radius = (std::max)(sum, 0.) - a.radius;
  return balls;
}

// Returns the share of the answers of the filter that are certain.
template <std::size_t Dimension>
double check_filter(int bits, double offset, int closeness, int exponent)
{
  const int count = 300;
  int certain = 0;
  Random random(static_cast<unsigned int>(bits + closeness));
  for(int k = 0; k < count; ++k) {
    const Two_balls<Dimension> balls = near_tie<Dimension>(bits, offset, closeness, random);
    const bool expected = do_intersect_exactly(balls);
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      const CGAL::Uncertain<bool> found = internal::Ball_box_filter::do_intersect(
        balls.first.box(exponent), balls.second.box(exponent));
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
void check_filter_of_near_ties()
{
  for(const int bits : {2, 4, 7, 20, 40, 51})
    for(const double offset : {0., 0x1p40, 0x1p53 - std::ldexp(1., bits)}) // ends are rounded
      for(const int closeness : {1, 3, 5, 20, 40, 44, 45, 46, 47, 48, 50, 52})
        for(const int exponent : {-1074, -540, -530, -500, -400, 0, 400, 460, 490, 900, 970})
          check_filter<Dimension>(bits, offset, closeness, exponent);
}

BOOST_AUTO_TEST_CASE(boxes_are_right_or_undecided)
{
  check_filter_of_near_ties<2>();
  check_filter_of_near_ties<3>();
  check_filter_of_near_ties<8>();
}

BOOST_AUTO_TEST_CASE(boxes_decide_all_but_near_ties)
{
  BOOST_CHECK_EQUAL(check_filter<2>(40, 0, 30, 0), 1);
  BOOST_CHECK_EQUAL(check_filter<3>(40, 0, 30, -400), 1);
  BOOST_CHECK_EQUAL(check_filter<8>(40, 0, 30, 400), 1);
  BOOST_CHECK_LT(check_filter<3>(51, 0, 52, 0), .1);
}

// The filter relies on it.
BOOST_AUTO_TEST_CASE(ends_of_boxes_are_off_by_at_most_two_steps)
{
  Random random(7);
  for(int k = 0; k < 1000; ++k) {
    const double center = random.uniform() - .5, radius = std::ldexp(random.uniform(), -k % 60);
    for(const int mode : rounding_modes) {
      const Rounding_mode rounding(mode);
      const auto [low, high] = internal::ball_interval(Ball_2(Point_2(center, 0), radius), 0);
      const Rational step(std::numeric_limits<double>::epsilon()
                          * (std::max)(std::fabs(low), std::fabs(high)));
      const Rational low_error(Rational(center) - Rational(radius) - Rational(low));
      const Rational high_error(Rational(high) - Rational(center) - Rational(radius));
      BOOST_CHECK(low_error >= 0 && low_error <= 2 * step);
      BOOST_CHECK(high_error >= 0 && high_error <= 2 * step);
    }
  }
}

// ---- integers -----------------------------------------------------------------------------------

std::optional<bool> decide(const Two_balls<8>& balls, int dimension, int exponent)
{
  const Ball<8>& a = balls.first;
  const Ball<8>& b = balls.second;
  const auto scaled = [&](double steps) { return std::ldexp(steps, exponent); };
  return internal::do_balls_intersect_in_integers(
    [&](int i) { return scaled(a.center[i]); }, scaled(a.radius),
    [&](int i) { return scaled(b.center[i]); }, scaled(b.radius), dimension);
}

bool do_intersect(const Two_balls<8>& balls, std::size_t dimension, int exponent)
{
  const auto scaled = [&](const Ball<8>& ball) {
    std::pair<Plain_point<double>, double> result = {{}, std::ldexp(ball.radius, exponent)};
    for(std::size_t i = 0; i < dimension; ++i)
      result.first.coordinates.push_back(std::ldexp(ball.center[i], exponent));
    return result;
  };
  return do_intersect(scaled(balls.first), scaled(balls.second));
}

BOOST_AUTO_TEST_CASE(near_ties_are_decided_in_integers_on_every_grid)
{
  Random random(17);
  int touching = 0;
  for(const int mode : rounding_modes)
    for(int trial = 0; trial < 20000; ++trial) {
      const int dimension = 1 + static_cast<int>(random.below(8));
      const int bits = 2 + static_cast<int>(random.below(49));
      const int exponent = static_cast<int>(random.below(1900)) - 1070;
      const Two_balls<8> balls = near_tie<8>(bits, -std::ldexp(1., bits - 1), 60, random,
                                             static_cast<std::size_t>(dimension));
      const bool expected = do_intersect_exactly(balls);
      const Rounding_mode guard(mode);
      const std::optional<bool> is = decide(balls, dimension, exponent);
      BOOST_REQUIRE(is.has_value());
      BOOST_REQUIRE_EQUAL(*is, expected);
      BOOST_REQUIRE_EQUAL(do_intersect(balls, static_cast<std::size_t>(dimension), exponent),
                          expected);
      touching += expected;
    }
  BOOST_TEST(touching > 10000);
}

BOOST_AUTO_TEST_CASE(numbers_that_do_not_fit_are_left_undecided)
{
  const auto origin = [](int) { return 0.; };
  const auto fine = [](int) { return 0x1p-70; };
  BOOST_TEST(!internal::do_balls_intersect_in_integers(origin, 1., fine, 0., 2).has_value());
  BOOST_TEST(!internal::do_balls_intersect_in_integers(origin, 1., origin, 1., 9).has_value());
  BOOST_TEST(internal::do_balls_intersect_in_integers(origin, 0., origin, 0., 8).value());
}

BOOST_AUTO_TEST_CASE(centers_far_from_each_other_are_beyond_the_radii)
{
  const auto low = [](int) { return -0x1p1023; };
  const auto high = [](int) { return 0x1p1023; };
  BOOST_TEST(!internal::do_balls_intersect_in_integers(low, 1., high, 1., 3).value());
  BOOST_TEST(internal::do_balls_intersect_in_integers(low, 0x1p1023, high, 0x1p1023, 1).value());
  BOOST_TEST(!internal::do_balls_intersect_in_integers(low, 0x1p1023, high, 0x1p1023, 2).value());
}

BOOST_AUTO_TEST_SUITE_END()
