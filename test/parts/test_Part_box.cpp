// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The box of a part, the points near it, and which parts receive a point.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

BOOST_AUTO_TEST_SUITE(Part_box)

using namespace test_support;

struct Bounds
{
  std::array<std::pair<double, double>, 2> x;
  std::pair<double, double> bounds_along(int axis) const
  {
    return x[static_cast<std::size_t>(axis)];
  }
};

// A point of the plane whose coordinates are doubles.
Bounds point(double x, double y)
{
  return {{{{x, x}, {y, y}}}};
}

BOOST_AUTO_TEST_CASE(points_at_exactly_the_reach_are_near_on_all_sides)
{
  internal::Part_box box(2);
  box.add(point(0, 0));
  box.add(point(4, 2));
  for(const Bounds& x : {point(5, 1), point(-1, 1), point(2, 3), point(2, -1)}) {
    BOOST_CHECK(box.is_near(x, 1));
    BOOST_CHECK(!box.is_near(x, std::nextafter(1., 0.)));
  }
}

// The reach is that along an axis: squares of differences are rounded, these are not.
BOOST_AUTO_TEST_CASE(points_within_reach_along_each_axis_are_near)
{
  internal::Part_box box(2);
  box.add(point(0, 0));
  BOOST_CHECK(box.is_near(point(1, 1), 1));
  const double tiny = 0x1p-600; // its square is zero
  BOOST_CHECK(box.is_near(point(tiny, 0), tiny));
  BOOST_CHECK(!box.is_near(point(2 * tiny, 0), tiny));
}

// The two points are within reach in real numbers, and their rounded difference does not tell.
BOOST_AUTO_TEST_CASE(rounding_never_loses_a_point_within_reach)
{
  const double reach = 0.1;
  int rounded_count = 0;
  for(int i = 0; i < 1000; ++i) {
    const double y = 0.001 + i * 0.0001; // with bits below those of x
    double x = y + reach;
    while(static_cast<long double>(x) - y > reach)
      x = std::nextafter(x, 0.);
    rounded_count += static_cast<long double>(x - y) != static_cast<long double>(x) - y;
    internal::Part_box box(2);
    box.add(point(y, 0));
    BOOST_CHECK(box.is_near(point(x, 0), reach));
    internal::Part_box other(2);
    other.add(point(x, 0));
    BOOST_CHECK(other.is_near(point(y, 0), reach));
  }
  BOOST_CHECK_GT(rounded_count, 100);
}

// Numbers that are not doubles are anywhere between two of them.
BOOST_AUTO_TEST_CASE(a_box_holds_both_bounds_of_each_coordinate)
{
  internal::Part_box box(2);
  box.add(Bounds{{{{1, 2}, {1, 2}}}});
  BOOST_CHECK_EQUAL(box.intervals()[0].low, 1);
  BOOST_CHECK_EQUAL(box.intervals()[0].high, 2);
  BOOST_CHECK(box.is_near(point(3, 1), 1));
  BOOST_CHECK(box.is_near(Bounds{{{{3, 9}, {1, 1}}}}, 1));
  BOOST_CHECK(box.is_near(Bounds{{{{-9, 0}, {1, 1}}}}, 1));
}

BOOST_AUTO_TEST_CASE(no_point_is_near_an_empty_box)
{
  const internal::Part_box box(2);
  BOOST_CHECK(box.is_empty());
  BOOST_CHECK(!box.is_near(point(0, 0), infinity));
}

BOOST_AUTO_TEST_CASE(numbers_beyond_doubles_are_near_what_they_may_be_near)
{
  constexpr double most = (std::numeric_limits<double>::max)();
  internal::Part_box box(2);
  box.add(Bounds{{{{most, infinity}, {0, 0}}}});
  BOOST_CHECK(box.is_near(Bounds{{{{most, infinity}, {0, 0}}}}, 1));
  BOOST_CHECK(!box.is_near(point(0, 0), 1));
  BOOST_CHECK(box.is_near(point(0, 0), infinity));
}

struct On_line
{
  double x;
  std::pair<double, double> bounds_along(int) const { return {x, x}; }
};

internal::Part_box interval(double low, double high)
{
  internal::Part_box box(1);
  box.add(On_line{low});
  box.add(On_line{high});
  return box;
}

BOOST_AUTO_TEST_CASE(exactly_one_of_two_parts_receives)
{
  for(int a = 0; a < 40; ++a)
    for(int b = 0; b < 40; ++b)
      BOOST_CHECK_EQUAL(internal::receives(a, b) + internal::receives(b, a), a != b);
}

BOOST_AUTO_TEST_CASE(a_part_receives_from_half_of_the_others)
{
  for(const int count : {2, 7, 40})
    for(int a = 0; a < count; ++a) {
      int others = 0;
      for(int b = 0; b < count; ++b)
        others += internal::receives(a, b);
      BOOST_CHECK_GE(others, (count - 1) / 2 - (count % 2 == 0));
      BOOST_CHECK_LE(others, count / 2);
    }
}

// Part 1 receives from part 2, and part 2 from part 0. Part 0 has two boxes around those of others,
// and part 1 has two boxes.
BOOST_AUTO_TEST_CASE(a_part_receives_a_point_near_two_of_its_boxes_once)
{
  const std::vector<internal::Part_box> mine = {internal::Part_box(1), interval(4, 6)};
  const std::vector<int> parts = {0, 0, 1, 1, 2};
  const std::vector<internal::Interval> all = {{1, 3}, {7, 9}, {3, 3.5}, {6.5, 7}, {4, 6}};
  const auto receivers = [&](std::size_t box, double x, double reach) {
    std::vector<int> found;
    const internal::Near_boxes near(mine, 2, parts, all, reach);
    near.for_receivers(box, On_line{x}, [&](int part) { found.push_back(part); });
    return found;
  };
  BOOST_CHECK(receivers(1, 4, 0.5) == std::vector<int>{1});
  BOOST_CHECK(receivers(1, 6, 0.5) == std::vector<int>{1});
  BOOST_CHECK(receivers(1, 5, 3) == std::vector<int>{1});
  BOOST_CHECK(receivers(1, 5, 0.5).empty());
  BOOST_CHECK(receivers(0, 5, 3).empty());
}

BOOST_AUTO_TEST_SUITE_END()
