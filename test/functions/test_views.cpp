// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Views of C++20: ranges that are not const, that end in a sentinel, or that make their elements.

#include "support/pairs.h"
#include "support/unit_test.h"

#include <CGAL/closest_pair.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <CGAL/thick_intersection_d.h>

#include <ranges>

using namespace test_support;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;

namespace {

// At 0, 1, 2, ... on a line.
std::vector<Point> points_of_line(int size)
{
  std::vector<Point> points;
  for(int i = 0; i < size; ++i)
    points.emplace_back(i, 0);
  return points;
}

const auto bound = CGAL::within_distance(2);

template <class Range>
Pairs pairs_of(Range&& range)
{
  Pairs pairs;
  CGAL::fixed_radius_near_neighbors(range, bound, std::back_inserter(pairs));
  return sorted(pairs);
}

bool is_even(const Point& p)
{
  return static_cast<int>(p.x()) % 2 == 0;
}

} // namespace

BOOST_AUTO_TEST_CASE(filtered_points_are_numbered_without_the_others)
{
  const std::vector<Point> points = points_of_line(7);
  BOOST_CHECK(pairs_of(points | std::views::filter(is_even)) == (Pairs{{0, 1}, {1, 2}, {2, 3}}));
  std::vector<std::pair<Point, Point>> pairs;
  CGAL::fixed_radius_near_neighbors(points | std::views::filter(is_even), bound,
                                    CGAL::with_elements(std::back_inserter(pairs)));
  for(const auto& [p, q] : pairs)
    BOOST_CHECK(is_even(p) && is_even(q));
}

BOOST_AUTO_TEST_CASE(a_view_may_end_in_a_sentinel)
{
  const std::vector<Point> points = points_of_line(9);
  const auto is_left = [](const Point& p) { return p.x() < 3; };
  BOOST_CHECK(pairs_of(points | std::views::take_while(is_left))
              == (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  auto evens = points | std::views::filter(is_even) | std::views::take_while(is_left);
  BOOST_CHECK(pairs_of(evens) == (Pairs{{0, 1}}));
}

BOOST_AUTO_TEST_CASE(a_view_may_make_its_elements)
{
  const auto made = std::views::iota(0, 4)
                    | std::views::transform([](int i) { return Point(3 * (i / 2), 0); });
  BOOST_CHECK(pairs_of(made) == (Pairs{{0, 1}, {2, 3}}));
}

BOOST_AUTO_TEST_CASE(all_functions_take_views)
{
  const std::vector<Point> points = points_of_line(8);
  const auto evens = std::views::filter(is_even);
  BOOST_CHECK(CGAL::closest_pair(points | evens) == Pair(0, 1));
  BOOST_CHECK(!CGAL::has_close_pair(points | evens, CGAL::within_distance(1)));
  BOOST_CHECK_EQUAL(CGAL::fixed_radius_neighbor_lists(points | evens, bound).number_of_pairs(), 3u);

  Pairs pairs;
  CGAL::fixed_radius_near_neighbors(points | evens, points | std::views::take(1), bound,
                                    std::back_inserter(pairs));
  BOOST_CHECK(sorted(pairs) == (Pairs{{0, 0}, {1, 0}}));

  const auto segment = std::views::transform(
    [](const Point& p) { return Kernel::Segment_2(p, Point(p.x(), 5)); });
  pairs.clear();
  CGAL::fixed_radius_near_neighbors(points | evens | segment, points | std::views::take(3),
                                    CGAL::within_distance(1), std::back_inserter(pairs));
  BOOST_CHECK(sorted(pairs) == (Pairs{{0, 0}, {0, 1}, {1, 1}, {1, 2}}));
  std::vector<std::pair<Kernel::Segment_2, Point>> elements;
  CGAL::fixed_radius_near_neighbors(points | evens | segment, points | std::views::take(1),
                                    CGAL::within_distance(1),
                                    CGAL::with_elements(std::back_inserter(elements)));
  BOOST_REQUIRE_EQUAL(elements.size(), 1u);
  BOOST_CHECK(elements.front().first.source() == elements.front().second);

  const auto box = std::views::transform([](const Point& p) { return p.bbox(); });
  pairs.clear();
  CGAL::thick_intersection_d(points | evens | box, points | box, std::back_inserter(pairs));
  BOOST_CHECK(sorted(pairs) == (Pairs{{0, 0}, {1, 2}, {2, 4}, {3, 6}}));
}
