// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The distance predicate, pair by pair, where floating point fails: exact ties, neighbours of ties,
// overflow, underflow; and the profile that says when doubles do not fail.

#define BOOST_TEST_MODULE predicates
#include "support/exact_points.h"
#include "support/point_generators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/Thick_point_traits_d.h>

#include <boost/test/unit_test.hpp>

#include <cfenv>
#include <random>
#include <sstream>

using namespace test_support;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Epick::Point_2;
using Point_3 = Epick::Point_3;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

template <class Point, class NT>
bool is_within(const CGAL::Distance_bound<NT>& bound, const Point& p, const Point& q)
{
  return CGAL::Thick_point_traits_d<Point>(bound).do_intersect_d_object()(p, q);
}

// Triples a^2 + b^2 = c^2, times an odd number of 20 bits: ties whose squares take 60 bits.
struct Tie
{
  double a, b, c;
};

std::vector<Tie> large_ties()
{
  std::vector<Tie> ties;
  std::mt19937_64 random(3);
  while(ties.size() < 4096) {
    const double m = static_cast<double>(2 + random() % 30);
    const double n = static_cast<double>(1 + random() % 30);
    const double h = static_cast<double>((random() % (1 << 20)) | (1 << 19) | 1);
    if(m > n)
      ties.push_back({h * (m * m - n * n), h * 2 * m * n, h * (m * m + n * n)});
  }
  return ties;
}

} // namespace

BOOST_AUTO_TEST_CASE(exact_ties_are_decided_right)
{
  std::size_t rounded_apart = 0; // so the test tests something
  for(const Tie& tie : large_ties()) {
    const Point_2 p(0, 0), q(tie.a, tie.b);
    BOOST_REQUIRE(is_within(CGAL::within_distance(tie.c), p, q));
    BOOST_REQUIRE(!is_within(CGAL::within_distance(tie.c).open(), p, q));
    BOOST_REQUIRE(!is_within(CGAL::within_distance(std::nextafter(tie.c, 0.)), p, q));
    BOOST_REQUIRE(is_within(CGAL::within_distance(std::nextafter(tie.c, infinity)).open(), p, q));
    const Point_3 s(0, tie.a, tie.b);
    BOOST_REQUIRE(is_within(CGAL::within_distance(tie.c), Point_3(0, 0, 0), s));
    BOOST_REQUIRE(!is_within(CGAL::within_distance(tie.c).open(), Point_3(0, 0, 0), s));
    rounded_apart += tie.a * tie.a + tie.b * tie.b != tie.c * tie.c;
  }
  BOOST_CHECK_GT(rounded_apart, 100u);
}

// d^2 = r^2 + 1 and d^2 = r^2 - 1, with r^2 of 100 bits.
BOOST_AUTO_TEST_CASE(near_misses_are_decided_right)
{
  for(double n = 1e6; n < 1.5e7; n += 12347) {
    const double r = 2 * n * n; // x^2 + y^2 = (2n^2 - 1)^2 + (2n)^2 = r^2 + 1
    const Point_2 p(0, 0), q(r - 1, 2 * n);
    BOOST_REQUIRE(!is_within(CGAL::within_distance(r), p, q));
    const CGAL::Exact_rational r2 = CGAL::Exact_rational(r) * r;
    BOOST_REQUIRE(is_within(CGAL::within_squared_distance(CGAL::Exact_rational(r2 + 1)), p, q));
    BOOST_REQUIRE(
      !is_within(CGAL::within_squared_distance(CGAL::Exact_rational(r2 + 1)).open(), p, q));
  }
}

BOOST_AUTO_TEST_CASE(squares_that_overflow_or_vanish)
{
  for(const double scale : {1e308 / 8, 1e200, 1e155, 1e-160, 1e-200, 5e-324 * 4}) {
    const Point_2 p(0, 0), q(3 * scale, 4 * scale);
    const double r = 5 * scale;
    const bool is_tie = r == scale * 5 && q.x() / 3 == scale && q.y() / 4 == scale;
    const Exact_points exact({{0, 0}, {q.x(), q.y()}}, Radius::of_length(r));
    const int sign = exact.compare_distance_with_radius(0, 1);
    BOOST_CHECK_EQUAL(is_within(CGAL::within_distance(r), p, q), sign <= 0);
    BOOST_CHECK_EQUAL(is_within(CGAL::within_distance(r).open(), p, q), sign < 0);
    BOOST_CHECK_MESSAGE(is_tie || sign != 0, scale);
    BOOST_CHECK(is_within(CGAL::within_distance(1.01 * r), p, q));
    BOOST_CHECK(!is_within(CGAL::within_distance(0.75 * r), p, q));
    BOOST_CHECK(is_within(CGAL::within_distance(r), p, p));
  }
}

// Random points around a circle, in each rounding mode, with coordinates of every magnitude.
BOOST_AUTO_TEST_CASE(near_the_circle_in_every_rounding_mode)
{
  std::mt19937_64 random(11);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5; };
  for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for(int i = 0; i < 5000; ++i) {
      const int exponent = static_cast<int>(random() % 2000) - 1040;
      const double x = std::ldexp(uniform(), exponent), y = std::ldexp(uniform(), exponent);
      const double r = std::hypot(x, y);
      const Exact_points exact({{0, 0}, {x, y}}, Radius::of_length(r));
      const int sign = exact.compare_distance_with_radius(0, 1);

      std::fesetround(mode);
      const bool closed = is_within(CGAL::within_distance(r), Point_2(0, 0), Point_2(x, y));
      const bool open = is_within(CGAL::within_distance(r).open(), Point_2(0, 0), Point_2(x, y));
      std::fesetround(FE_TONEAREST);
      BOOST_REQUIRE_EQUAL(closed, sign <= 0);
      BOOST_REQUIRE_EQUAL(open, sign < 0);
    }
}

// Points whose differences are no doubles, at a distance that is the rounded one, or the exact one
// but for a part in 2^110; in each rounding mode.
BOOST_AUTO_TEST_CASE(near_ties_of_inexact_differences)
{
  using Rational = CGAL::Exact_rational;
  std::mt19937_64 random(12);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5; };
  for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for(int i = 0; i < 2000; ++i) {
      const double scale = std::ldexp(1., -static_cast<int>(random() % 60));
      const Point_3 p(scale * uniform(), scale * uniform(), scale * uniform());
      const Point_3 q(uniform(), uniform(), uniform());
      Rational d2 = 0;
      for(int axis = 0; axis < 3; ++axis) {
        const Rational difference = Rational(p[axis]) - Rational(q[axis]);
        d2 += difference * difference;
      }
      const double r = std::sqrt(CGAL::to_double(d2));
      const bool is_within_r = d2 <= Rational(r) * Rational(r);
      const Rational part = d2 * Rational(std::ldexp(1., -110));
      const Rational above = d2 + part, below = d2 - part;

      std::fesetround(mode);
      const bool rounded = is_within(CGAL::within_distance(r), p, q);
      const bool greater = is_within(CGAL::within_squared_distance(above), p, q);
      const bool less = is_within(CGAL::within_squared_distance(below), p, q);
      const bool equal = is_within(CGAL::within_squared_distance(d2), p, q);
      const bool open = is_within(CGAL::within_squared_distance(d2).open(), p, q);
      std::fesetround(FE_TONEAREST);
      BOOST_REQUIRE_EQUAL(rounded, is_within_r);
      BOOST_REQUIRE(greater && !less && equal && !open);
    }
}

// Wrong in doubles though all numbers are floats: [V03], section 3, takes this for safe.
BOOST_AUTO_TEST_CASE(floats_do_not_make_doubles_exact)
{
  const double tiny = std::ldexp(1., -27);
  BOOST_CHECK_EQUAL(1. + tiny * tiny, 1.);
  BOOST_CHECK(!is_within(CGAL::within_distance(1), Point_2(0, 0), Point_2(1, tiny)));
  const std::vector<Point_2> points = {{0, 0}, {1, tiny}};
  BOOST_CHECK(CGAL::profile_scene(points, CGAL::within_distance(1)).tier()
              == CGAL::Arithmetic_tier::INT64);
}

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

BOOST_AUTO_TEST_CASE(inner_balls_intersect_outer_ones)
{
  using Ball = std::pair<Point_3, double>;
  const std::vector<Ball> balls = {{Point_3(0, 0, 0), 10}, {Point_3(1, 0, 0), 1}};
  const auto do_intersect = CGAL::Thick_ball_traits_d<Point_3>(balls).do_intersect_d_object();
  BOOST_CHECK(do_intersect(balls[0], balls[1]));
  BOOST_CHECK(do_intersect(balls[0], balls[0]));
}

// --- the profile

namespace {

CGAL::Scene_profile profile_of_units(int dimension, double reach, int exponent)
{
  return CGAL::Scene_profile(2, std::vector<std::pair<double, double>>(dimension, {0, reach}),
                             reach, exponent);
}

} // namespace

// d U^2 <= 2^53: the largest U is 67,108,864 in the plane and 54,794,158 in space.
// For 64 bits, d U^2 is below 2^63, and for 128 bits U itself: the double before it is 1024 less.
BOOST_AUTO_TEST_CASE(tiers_are_certified_up_to_their_limits)
{
  using Tier = CGAL::Arithmetic_tier;
  const double two_to_63 = std::ldexp(1., 63);
  for(const int exponent : {0, -20, 30}) {
    const auto tier = [&](int dimension, double units) {
      return profile_of_units(dimension, std::ldexp(units, exponent), exponent).tier();
    };
    BOOST_CHECK(tier(1, 67108864) == Tier::DOUBLE);
    BOOST_CHECK(tier(2, 67108864) == Tier::DOUBLE);
    BOOST_CHECK(tier(2, 67108865) == Tier::INT64);
    BOOST_CHECK(tier(3, 54794158) == Tier::DOUBLE);
    BOOST_CHECK(tier(3, 54794159) == Tier::INT64);
    BOOST_CHECK(tier(1, 3037000499) == Tier::INT64);
    BOOST_CHECK(tier(1, 3037000500) == Tier::INT128);
    BOOST_CHECK(tier(2, 2147483647) == Tier::INT64);
    BOOST_CHECK(tier(2, 2147483648) == Tier::INT128);
    BOOST_CHECK(tier(3, 1753413056) == Tier::INT64);
    BOOST_CHECK(tier(3, 1753413057) == Tier::INT128);
    for(const int dimension : {1, 2, 3, 4}) {
      BOOST_CHECK(tier(dimension, two_to_63 - 1024) == Tier::INT128);
      BOOST_CHECK(tier(dimension, two_to_63) == Tier::FILTERED_EXACT);
    }
    BOOST_CHECK(tier(5, two_to_63 - 1024) == Tier::FILTERED_EXACT);
    BOOST_CHECK(tier(5, std::floor(two_to_63 * 0.894)) == Tier::INT128); // sqrt(4/5) = 0.8944...
    BOOST_CHECK(tier(5, std::floor(two_to_63 * 0.895)) == Tier::FILTERED_EXACT);
  }
}

BOOST_AUTO_TEST_CASE(doubles_are_not_certified_where_squares_vanish_or_overflow)
{
  using Tier = CGAL::Arithmetic_tier;
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., -530), -537).tier() == Tier::DOUBLE);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., -530), -538).tier() == Tier::INT64);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., 500), 490).tier() == Tier::DOUBLE);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., 501), 490).tier() == Tier::INT64);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1., 1022), 1010).tier() == Tier::INT64);
  BOOST_CHECK(profile_of_units(2, std::ldexp(1.5, 1022), 1010).tier() == Tier::FILTERED_EXACT);
  BOOST_CHECK(CGAL::Scene_profile(2, {{0, 1}, {0, 1}}, 1, std::nullopt).tier()
              == Tier::FILTERED_EXACT);
}

// At the limit: near misses on the grid, and far pairs, in the certified arithmetic.
BOOST_AUTO_TEST_CASE(certified_doubles_are_exact_at_the_limit)
{
  std::mt19937_64 random(13);
  const double limit = 67108864;
  const std::vector<Point_2> scene = {{0, 0}, {1, 0}, {1e15, 0}};
  namespace internal = CGAL::Thick_intersection_d::internal;
  const internal::Numbered_elements<std::vector<Point_2>> elements(scene);
  const internal::Scene scanned = internal::scan_points<CGAL::Sequential_tag>(elements, "point");
  for(int i = 0; i < 20000; ++i) {
    const double r = limit - static_cast<double>(random() % 1000);
    const auto bound = CGAL::within_distance(r);
    const CGAL::Scene_profile profile = CGAL::profile_scene(scene, bound);
    BOOST_REQUIRE(profile.tier() == CGAL::Arithmetic_tier::DOUBLE);
    const double x = static_cast<double>(random() % static_cast<std::uint64_t>(r));
    const double y = std::floor(std::sqrt(r * r - x * x)) + static_cast<double>(random() % 3) - 1;
    const internal::Is_within_distance<Point_2> certified(
      internal::Squared_bound<internal::Exact_number_t<double>>(bound), scanned, profile.tier());
    const Integer left = Integer(x) * Integer(x) + Integer(y) * Integer(y);
    BOOST_REQUIRE_EQUAL(certified(Point_2(-7, 9), Point_2(x - 7, y + 9)),
                        left <= Integer(r) * Integer(r));
    BOOST_REQUIRE(!certified(Point_2(0, 0), Point_2(1e15, 0)));
    BOOST_REQUIRE(!certified(Point_2(0, 0), Point_2(0, r + 1)));
  }
}

BOOST_AUTO_TEST_CASE(profile_finds_grid_and_box)
{
  const std::vector<Point_2> points = {{0.5, 1024}, {-3, 0.375}, {0, 0}};
  const CGAL::Scene_profile profile = CGAL::profile_scene(points, CGAL::within_distance(2));
  BOOST_CHECK_EQUAL(profile.size(), 3u);
  BOOST_CHECK_EQUAL(profile.dimension(), 2);
  BOOST_CHECK_EQUAL(profile.grid_exponent(), -3);
  BOOST_CHECK_EQUAL(profile.units(), 16);
  BOOST_CHECK_EQUAL(profile.range(0).first, -3);
  BOOST_CHECK_EQUAL(profile.range(1).second, 1024);
  BOOST_CHECK_EQUAL(profile.bits(), 9);
  std::ostringstream text;
  text << profile;
  BOOST_CHECK_MESSAGE(text.str().find("arithmetic  double\n") != std::string::npos, text.str());

  const std::vector<Point_2> denormal = {{5e-324, 1}, {0, 0}};
  const auto fine = CGAL::profile_scene(denormal, CGAL::within_distance(1));
  BOOST_CHECK_EQUAL(fine.grid_exponent(), -1074);
  BOOST_CHECK(fine.tier() == CGAL::Arithmetic_tier::FILTERED_EXACT);
  const std::vector<Point_2> zeros = {{0, 0}, {-0., 0}};
  BOOST_CHECK(CGAL::profile_scene(zeros, CGAL::within_distance(1)).tier()
              == CGAL::Arithmetic_tier::DOUBLE);
}

// The threshold of the certified tier is the square of the radius rounded down, to the last bit.
BOOST_AUTO_TEST_CASE(thresholds_are_the_largest_doubles_within)
{
  using Bound = CGAL::Thick_intersection_d::internal::Squared_bound<CGAL::Exact_rational>;
  BOOST_CHECK_EQUAL(Bound(CGAL::within_distance(5)).largest_double(), 25);
  BOOST_CHECK_EQUAL(Bound(CGAL::within_distance(5).open()).largest_double(),
                    std::nextafter(25., 0.));
  BOOST_CHECK_LT(Bound(CGAL::within_distance(0).open()).largest_double(), 0);
  for(double r = 0.1; r < 3; r += 0.1) {
    const double threshold = Bound(CGAL::within_distance(r)).largest_double();
    const Rational r2 = Rational(r) * Rational(r);
    BOOST_CHECK(Rational(threshold) <= r2);
    BOOST_CHECK(Rational(std::nextafter(threshold, infinity)) > r2);
  }
}

// --- numbers

BOOST_AUTO_TEST_CASE(numbers_are_converted_without_rounding)
{
  using CGAL::Thick_intersection_d::internal::to_exact_rational;
  using Exact = CGAL::Exact_rational;
  const auto power_of_two = [](int e) { return Exact(std::ldexp(1., e)); };
  BOOST_CHECK(to_exact_rational(0.1) == Exact(0.1));
  BOOST_CHECK(to_exact_rational(0.1f) == Exact(double(0.1f)));
  BOOST_CHECK(to_exact_rational((std::numeric_limits<long>::min)()) == -power_of_two(63));
  BOOST_CHECK(to_exact_rational((std::numeric_limits<unsigned long>::max)())
              == power_of_two(64) - 1);
  BOOST_CHECK(to_exact_rational(-7l) == -7);
  const long double third = 1.l / 3;
  const double head = static_cast<double>(third);
  BOOST_CHECK(to_exact_rational(third)
              == Exact(head) + Exact(static_cast<double>(third - static_cast<long double>(head))));
  BOOST_CHECK(to_exact_rational(CGAL::Quotient<int>(1, 3)) == Exact(1) / 3);
}
