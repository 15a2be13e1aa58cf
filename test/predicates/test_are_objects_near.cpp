// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which arithmetic decides about the distance of two objects, and that its answers are right.

#include "support/unit_test.h"
#include "support/usual_kernels.h"

#include <CGAL/Thick_intersection_d/internal/predicates/are_objects_near.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_objects_intersect.h>

BOOST_AUTO_TEST_SUITE(are_objects_near)

using namespace test_support;
using CGAL::Arithmetic_tier;
using Doubles = Double_kernel;
using Ball = std::pair<Doubles::Point_2, double>;
using Exact_ball = std::pair<Epeck::Point_2, Epeck::FT>;

const Arithmetic_tier first_tier = Arithmetic_tier::INT64;

struct Answer
{
  bool is_near;
  Arithmetic_tier tier;
};

template <class A, class B, class NT>
Answer answer(const A& a, const B& b, const CGAL::Distance_bound<NT>& bound,
              Arithmetic_tier tier = first_tier)
{
  using Exact = typename internal::Common_exact_number<std::tuple<A, B>>::type;
  const internal::Squared_bound<Exact> squared(bound);
  internal::Hull_bound hull_bound;
  internal::set_hull_bound(hull_bound, bound, squared);
  const auto exact_bound = [&]() -> const internal::Squared_bound<Exact>& { return squared; };
  const bool is_near = internal::are_kinds_near(a, b, hull_bound, exact_bound, tier);
  return {is_near, tier};
}

// A tie at this bound, which the tier decides: closed bounds hold, and open ones do not.
template <class A, class B, class NT>
void check_tie(const A& a, const B& b, const CGAL::Distance_bound<NT>& bound, Arithmetic_tier tier)
{
  for(const bool is_swapped : {false, true}) {
    const auto ask = [&](const auto& asked) {
      return is_swapped ? answer(b, a, asked) : answer(a, b, asked);
    };
    const Answer closed = ask(bound), open = ask(CGAL::Distance_bound<NT>(bound).open());
    BOOST_CHECK(closed.is_near && closed.tier == tier);
    BOOST_CHECK(!open.is_near && open.tier == tier);
  }
}

Doubles::Segment_2 segment(double x, double y, double x2, double y2)
{
  return {Doubles::Point_2(x, y), Doubles::Point_2(x2, y2)};
}

BOOST_AUTO_TEST_CASE(doubles_decide_what_is_clear)
{
  const auto a = segment(0, 0, 9, 0), b = segment(3, 4, 3, 9);
  const Answer yes = answer(a, b, CGAL::within_distance(4.001));
  const Answer no = answer(a, b, CGAL::within_distance(3.999));
  BOOST_CHECK(yes.is_near && yes.tier == Arithmetic_tier::DOUBLE);
  BOOST_CHECK(!no.is_near && no.tier == Arithmetic_tier::DOUBLE);
}

BOOST_AUTO_TEST_CASE(integers_decide_ties_on_a_grid)
{
  const auto a = segment(0, 0, 9, 0), b = segment(3, 4, 3, 9);
  check_tie(a, b, CGAL::within_distance(4.), Arithmetic_tier::INT128);
  check_tie(a, Ball(Doubles::Point_2(3, 4), 1), CGAL::within_distance(3.),
            Arithmetic_tier::INT128);
  const Answer forced = answer(a, b, CGAL::within_distance(4.), Arithmetic_tier::FILTERED_EXACT);
  BOOST_CHECK(forced.is_near && forced.tier == Arithmetic_tier::FILTERED_EXACT);
}

BOOST_AUTO_TEST_CASE(exact_numbers_decide_ties_off_the_grid)
{
  check_tie(segment(0, 0, .9, 0), segment(.3, .1, .3, .4), CGAL::within_distance(.1),
            Arithmetic_tier::FILTERED_EXACT);
  // No double has the root of two.
  const auto a = segment(0, 0, 1, 0), b = segment(2, 1, 3, 1);
  check_tie(a, b, CGAL::within_squared_distance(2.), Arithmetic_tier::FILTERED_EXACT);
  check_tie(Ball(Doubles::Point_2(0, 0), 1), Ball(Doubles::Point_2(5, 0), 2),
            CGAL::within_squared_distance(4.), Arithmetic_tier::FILTERED_EXACT);
}

// A length of lines that doubles can only enclose.
BOOST_AUTO_TEST_CASE(numbers_that_are_no_doubles)
{
  const Epeck::FT third = Epeck::FT(1) / 3;
  const Epeck::Segment_2 a(Epeck::Point_2(0, third), Epeck::Point_2(9, third));
  const Epeck::Segment_2 b(Epeck::Point_2(3, 2 * third), Epeck::Point_2(3, 5));
  check_tie(a, b, CGAL::within_distance(third), Arithmetic_tier::FILTERED_EXACT);
  // The bound is a double, and so is all of one object.
  const Epeck::Segment_2 c(Epeck::Point_2(3, 1 + third), Epeck::Point_2(3, 5));
  check_tie(a, c, CGAL::within_distance(1.), Arithmetic_tier::FILTERED_EXACT);
  const Exact_ball ball(Epeck::Point_2(3, 2), third);
  check_tie(segment(0, 0, 9, 0), ball, CGAL::within_distance(5 * third),
            Arithmetic_tier::FILTERED_EXACT);
  check_tie(a, ball, CGAL::within_distance(4 * third), Arithmetic_tier::FILTERED_EXACT);
  // The bound alone is no double.
  const Epeck::Segment_2 d(Epeck::Point_2(0, 0), Epeck::Point_2(9, 0));
  const Answer no = answer(d, Exact_ball(Epeck::Point_2(3, 1), 0),
                           CGAL::within_distance(Epeck::FT(1) - third * 0x1p-70));
  BOOST_CHECK(!no.is_near);
}

// The lower ends of the intervals are integers that make a tie, and the numbers are none.
BOOST_AUTO_TEST_CASE(integers_do_not_decide_about_ends_of_intervals)
{
  const Epeck::FT bit = Epeck::FT(0x1p-70) / 3, more = 1 + bit;
  const auto point = [](const Epeck::FT& x) { return Epeck::Point_2(x, 0); };
  const auto segment = [&](const Epeck::FT& x) {
    return Epeck::Segment_2(point(x), Epeck::Point_2(x, 5));
  };
  const auto check = [](const auto& a, const auto& b, bool is_near) {
    BOOST_CHECK_EQUAL(answer(a, b, CGAL::within_distance(2.)).is_near, is_near);
    BOOST_CHECK_EQUAL(answer(a, b, CGAL::within_distance(2.).open()).is_near, is_near);
    BOOST_CHECK_EQUAL(answer(b, a, CGAL::within_distance(2.)).is_near, is_near);
    BOOST_CHECK_EQUAL(answer(b, a, CGAL::within_distance(2.).open()).is_near, is_near);
  };
  check(segment(more), segment(-1), false);
  check(segment(more), segment(3), true);
  check(segment(0), Exact_ball(point(-3), more), true);
  check(Exact_ball(point(0), 1), Exact_ball(point(4), more), true);
  const CGAL::Distance_bound<double> bound = CGAL::within_squared_distance(1 + 0x1p-51);
  BOOST_CHECK(answer(segment(0), segment(1), bound.open()).is_near);
}

// The places of the points are known to 2^-12 only.
BOOST_AUTO_TEST_CASE(filter_knows_how_far_doubles_are_off)
{
  const Epeck::FT third = Epeck::FT(1) / 3;
  const Exact_ball a(Epeck::Point_2(0x1p40 + third, 0), 0);
  const Epeck::Segment_2 b(Epeck::Point_2(0x1p40 + 1.25, 0), Epeck::Point_2(0x1p40 + 1.25, 9));
  BOOST_CHECK(answer(a, b, CGAL::within_distance(.9167)).is_near);
  BOOST_CHECK(!answer(a, b, CGAL::within_distance(.9166)).is_near);
}

// The faces that are next to each other are not those of the nearest vertices.
BOOST_AUTO_TEST_CASE(objects_that_intersect_are_within_every_distance)
{
  const Doubles::Point_3 p(-9, -9, 0), q(9, -9, 0), r(0, 9, 0);
  const Doubles::Triangle_3 triangle(p, q, r);
  const Doubles::Segment_3 segment(Doubles::Point_3(0, 0, -5), Doubles::Point_3(0, 1, 5));
  const Answer crossing = answer(triangle, segment, CGAL::within_distance(0.));
  BOOST_CHECK(crossing.is_near && crossing.tier == Arithmetic_tier::INT128);
  const Doubles::Segment_3 touching(Doubles::Point_3(0, 0, 0), Doubles::Point_3(0, 1, 5));
  BOOST_CHECK(answer(triangle, touching, CGAL::within_distance(0.)).is_near);
}

BOOST_AUTO_TEST_CASE(balls_that_touch_intersect)
{
  const auto do_intersect = [](const auto& a, const auto& b) {
    Arithmetic_tier tier = first_tier;
    return internal::do_kinds_intersect(a, b, tier);
  };
  const auto a = segment(0, 0, 9, 0);
  BOOST_CHECK(do_intersect(a, Ball(Doubles::Point_2(3, 4), 4)));
  BOOST_CHECK(do_intersect(Ball(Doubles::Point_2(12, 4), 5), a));
  BOOST_CHECK(!do_intersect(a, Ball(Doubles::Point_2(3, 4), std::nextafter(4., 0))));
  BOOST_CHECK(do_intersect(Doubles::Point_2(3, 0), Ball(Doubles::Point_2(3, 4), 4)));
  BOOST_CHECK(do_intersect(Ball(Doubles::Point_2(3, 7), 3), Ball(Doubles::Point_2(3, 0), 4)));
}

template <class A, class B>
constexpr int distance_degree = internal::degree_of<internal::Distance_degree, A, B>();
template <class A, class B>
constexpr int intersection_degree = internal::degree_of<internal::Intersection_degree, A, B>();

BOOST_AUTO_TEST_CASE(degrees)
{
  using Point_2 = Doubles::Point_2;
  using Point_3 = Doubles::Point_3;
  using Segment = Doubles::Segment_2;
  using Box = Doubles::Iso_cuboid_3;
  using Object_3 = std::variant<Point_3, Doubles::Segment_3>;
  BOOST_CHECK_EQUAL((distance_degree<Point_2, Ball>), 2);
  BOOST_CHECK_EQUAL((distance_degree<Point_2, Segment>), 4);
  BOOST_CHECK_EQUAL((distance_degree<Point_3, Point_3>), 2);
  BOOST_CHECK_EQUAL((distance_degree<Object_3, Point_3>), 6);
  BOOST_CHECK_EQUAL((intersection_degree<Ball, Ball>), 2);
  BOOST_CHECK_EQUAL((intersection_degree<Ball, Segment>), 4);
  BOOST_CHECK_EQUAL((intersection_degree<Point_2, Segment>), 2);
  BOOST_CHECK_EQUAL((intersection_degree<Box, Box>), 1);
  BOOST_CHECK_EQUAL((intersection_degree<Point_3, Box>), 1);
  BOOST_CHECK_EQUAL((intersection_degree<Box, Object_3>), 3);
}

BOOST_AUTO_TEST_SUITE_END()
