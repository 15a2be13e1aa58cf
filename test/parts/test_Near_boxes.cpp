// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The boxes of parts, and which parts receive a point.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Near_boxes.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Near_boxes)

namespace internal = CGAL::Thick_intersection_d::internal;

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
