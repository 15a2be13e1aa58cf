// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The distance predicate, pair by pair: near ties that are on no grid, certified doubles up to
// their limit, and what is counted. Ties on grids of every size are in functions/test_fuzz.cpp.

#include "support/exact_points.h"
#include "support/plain_points.h"
#include "support/rounding_mode.h"
#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_point_traits_d.h>

BOOST_AUTO_TEST_SUITE(Is_within_distance)

using namespace test_support;
using CGAL::Arithmetic_tier;

using Point_2 = Epick::Point_2;
using Point_3 = Epick::Point_3;

template <class Point, class NT>
bool is_within(const CGAL::Distance_bound<NT>& bound, const Point& p, const Point& q)
{
  return CGAL::Thick_point_traits_d<Point>(bound).do_intersect_d_object()(p, q);
}

// Points whose differences are no doubles, at a distance that is the rounded one, or the exact one
// but for a part in 2^110; in each rounding mode.
BOOST_AUTO_TEST_CASE(near_ties_of_inexact_differences)
{
  using Rational = CGAL::Exact_rational;
  std::mt19937_64 random(12);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5; };
  for(const int mode : rounding_modes)
    for(int i = 0; i < 2000; ++i) {
      const double scale = std::ldexp(1., -static_cast<int>(random() % 60));
      const Point_3 p(scale * uniform(), scale * uniform(), scale * uniform());
      const Point_3 q(uniform(), uniform(), uniform());
      Rational d2 = 0;
      for(int axis = 0; axis < 3; ++axis)
        d2 += CGAL::square(Rational(p[axis]) - Rational(q[axis]));
      const double r = std::sqrt(CGAL::to_double(d2));
      const bool is_within_r = d2 <= Rational(r) * Rational(r);
      const Rational part = d2 * Rational(std::ldexp(1., -110));
      const Rational above = d2 + part, below = d2 - part;

      std::optional<Rounding_mode> in_mode(mode);
      const bool rounded = is_within(CGAL::within_distance(r), p, q);
      const bool greater = is_within(CGAL::within_squared_distance(above), p, q);
      const bool less = is_within(CGAL::within_squared_distance(below), p, q);
      const bool equal = is_within(CGAL::within_squared_distance(d2), p, q);
      const bool open = is_within(CGAL::within_squared_distance(d2).open(), p, q);
      in_mode.reset();
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

// At the limit: near misses on the grid, and far pairs, in the certified arithmetic.
BOOST_AUTO_TEST_CASE(certified_doubles_are_exact_at_the_limit)
{
  std::mt19937_64 random(13);
  const double limit = 67108864;
  const std::vector<Point_2> scene = {{0, 0}, {1, 0}, {1e15, 0}};
  const internal::Numbered_elements<std::vector<Point_2>> elements(scene);
  const internal::Scene scanned = internal::scan_points(elements, "point");
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

// --- the counts of decisions

std::uint64_t total(const internal::Decision_counts& counts)
{
  std::uint64_t sum = 0;
  for(const Arithmetic_tier tier : {Arithmetic_tier::DOUBLE, Arithmetic_tier::INT64,
                                    Arithmetic_tier::INT128, Arithmetic_tier::FILTERED_EXACT})
    sum += counts[tier];
  return sum;
}

// Asks about (0, 0) and `q` in the arithmetic of a tier, and checks which one decides; none is
// counted for pairs that the filter puts beyond the bound. Or asks the last question
// alone, which is left if no filter decides.
template <class Number>
void check_count(Arithmetic_tier tier, const Plain_point<Number>& q, bool is_within,
                 std::optional<Arithmetic_tier> decided_by, bool is_last = false)
{
  using Point = Plain_point<Number>;
  const Plain_points<Number> points = {{{Number(0), Number(0)}}, q};
  const internal::Squared_bound<internal::Exact_number_t<Number>> bound(CGAL::within_distance(5));
  const internal::Scene scene = internal::scan_points(points, "point");
  internal::Shared_decision_counts shared;
  const internal::Is_within_distance<Point> test(bound, scene, tier, &shared);
  internal::Decision_counts counts;
  BOOST_CHECK_EQUAL(is_last ? test.decide_undecided(points[0], points[1], counts)
                            : test(points[0], points[1]), is_within);
  if(!is_last)
    counts = shared.total();
  BOOST_CHECK_EQUAL(total(counts), decided_by ? 1u : 0u);
  if(decided_by)
    BOOST_CHECK_EQUAL(counts[*decided_by], 1u);
}

BOOST_AUTO_TEST_CASE(each_pair_is_decided_once)
{
  using Rational = CGAL::Exact_rational;
  const Plain_point<double> tie = {{3, 4}}, near = {{3, 3}}, far = {{3, 5}};
  const Rational third = Rational(1) / 3;
  const Plain_point<Rational> rational_tie = {{Rational(7) / 5, Rational(24) / 5}};
  const Plain_point<Rational> rational_near = {{third, third}};
  for(const Arithmetic_tier tier : {Arithmetic_tier::DOUBLE, Arithmetic_tier::INT64,
                                    Arithmetic_tier::INT128, Arithmetic_tier::FILTERED_EXACT}) {
    check_count<double>(tier, tie, true, tier);
    check_count<double>(tier, near, true, Arithmetic_tier::DOUBLE);
    check_count<double>(tier, far, false, std::nullopt);
  }
  check_count<double>(Arithmetic_tier::INT128, {{5, 1e-30}}, false, // which does not fit
                      Arithmetic_tier::FILTERED_EXACT);
  check_count<Rational>(Arithmetic_tier::FILTERED_EXACT, rational_tie, true,
                        Arithmetic_tier::FILTERED_EXACT);
  check_count<Rational>(Arithmetic_tier::FILTERED_EXACT, rational_near, true,
                        Arithmetic_tier::DOUBLE);
}

// Of doubles the filter has been asked before; of other coordinates it is asked again.
BOOST_AUTO_TEST_CASE(the_last_question_is_answered_once)
{
  using Rational = CGAL::Exact_rational;
  const Rational third = Rational(1) / 3;
  const auto exact = Arithmetic_tier::FILTERED_EXACT;
  check_count<double>(exact, {{3, 4}}, true, exact, true);
  check_count<double>(exact, {{std::nextafter(3, 4.), 4}}, false, exact, true);
  check_count<Rational>(exact, {{third, third}}, true, Arithmetic_tier::DOUBLE, true);
  check_count<Rational>(exact, {{Rational(7) / 5, Rational(24) / 5}}, true, exact, true);
}

// The sum of the reach and a much smaller error is rounded down.
BOOST_AUTO_TEST_CASE(the_reach_of_doubles_has_room_for_the_error)
{
  using Exact = CGAL::Exact_rational;
  using Point = CGAL::Simple_cartesian<Exact>::Point_2;
  internal::Scene scene;
  scene.size = 2;
  scene.box = {{0, 1}, {0, 1}};
  for(int exponent = -2; exponent > -100; --exponent) {
    scene.error = std::ldexp(1.25, exponent);
    const internal::Is_within_distance<Point> is_within(
      internal::Squared_bound<Exact>(CGAL::within_distance(1)), scene,
      Arithmetic_tier::FILTERED_EXACT);
    BOOST_CHECK(Exact(is_within.filter_of_doubles().reach) >= Exact(1) + Exact(scene.error));
    BOOST_CHECK_LE(is_within.filter_of_doubles().reach, 1 + scene.error + 1e-15);
  }
}

// The bounds of a lazy number are on both sides of the reach.
BOOST_AUTO_TEST_CASE(lazy_numbers_along_an_axis_are_compared_exactly)
{
  const Epeck::Point_2 origin(0, 0);
  const internal::Is_within_distance<Epeck::Point_2> is_within(
    internal::Squared_bound<Epeck::FT>(CGAL::within_distance(1)), 2);
  for(const double excess : {-1e-6, 0., 1e-6}) {
    const Epeck::FT x = Epeck::FT(1e10) / 3 * 3 - 1e10 + 1 + excess;
    const internal::Gap gap = internal::gap_along(origin, Epeck::Point_2(x, 0), 0);
    BOOST_REQUIRE(gap.inf < 1 - 1e-7 && gap.sup > 1 + 1e-7);
    BOOST_CHECK_EQUAL(is_within.is_within_along(origin, Epeck::Point_2(x, 0), 0), excess <= 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
