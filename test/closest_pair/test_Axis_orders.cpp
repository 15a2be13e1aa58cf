// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The orders along the axes: divided, each side is in order; merged, they are as before.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Axis_orders.h>

BOOST_AUTO_TEST_SUITE(Axis_orders)

using namespace test_support;
using internal::Rank;
using internal::Ranks;

// The points are those of the ranks, with few values along each axis.
Points random_points(int dimension, std::size_t size)
{
  Random random(size);
  return integer_points(dimension, size, 6, random);
}

// The ranks [first, last) along an axis; those of equal coordinates are in their own order.
Ranks sorted_ranks(const Points& points, int axis, Rank first, Rank last)
{
  Ranks ranks;
  for(Rank rank = first; rank < last; ++rank)
    ranks.push_back(rank);
  std::stable_sort(ranks.begin(), ranks.end(), [&](Rank a, Rank b) {
    return points[a][static_cast<std::size_t>(axis)] < points[b][static_cast<std::size_t>(axis)];
  });
  return ranks;
}

// The ranks [first, last) are at the places [first, last), in order along each axis.
void check_orders(internal::Axis_orders& orders, const Points& points, Rank first, Rank last)
{
  for(std::size_t i = 0; i < orders.size(); ++i) {
    const Ranks& ranks = orders[i].ranks;
    const Ranks expected = sorted_ranks(points, orders[i].axis, first, last);
    BOOST_CHECK(std::equal(expected.begin(), expected.end(),
                           ranks.begin() + static_cast<std::ptrdiff_t>(first)));
  }
}

// Divides down to single ranks and merges again, as the search does.
void divide_and_merge(internal::Axis_orders& orders, const Points& points, Rank first, Rank last)
{
  check_orders(orders, points, first, last);
  if(last - first < 2)
    return;
  const Rank middle = first + (last - first + 2) / 3; // not in the middle
  orders.divide(first, middle, last);
  divide_and_merge(orders, points, first, middle);
  divide_and_merge(orders, points, middle, last);
  orders.merge(first, middle, last);
  check_orders(orders, points, first, last);
}

internal::Axis_orders orders_of(const Points& points, int dimension)
{
  internal::Axis_orders orders;
  orders.sort(points.size(), dimension, [&](Rank a, Rank b, int axis) {
    return points[a][static_cast<std::size_t>(axis)] < points[b][static_cast<std::size_t>(axis)];
  });
  return orders;
}

BOOST_AUTO_TEST_CASE(merging_undoes_dividing)
{
  for(const int dimension : {1, 2, 3, 4})
    for(const std::size_t size : {0, 1, 2, 3, 17, 200}) {
      const Points points = random_points(dimension, size);
      internal::Axis_orders orders = orders_of(points, dimension);
      divide_and_merge(orders, points, 0, size);
    }
}

// All axes but the first have one; the line has one of its only axis.
BOOST_AUTO_TEST_CASE(each_axis_behind_the_first_has_an_order)
{
  for(const int dimension : {1, 2, 3, 4}) {
    const Points points = random_points(dimension, 50);
    internal::Axis_orders orders = orders_of(points, dimension);
    BOOST_CHECK_EQUAL(orders.size(), dimension == 1 ? 1u : static_cast<std::size_t>(dimension - 1));
    BOOST_CHECK_EQUAL(orders.last().axis, dimension - 1);
    for(std::size_t i = 0; i < orders.size(); ++i)
      for(std::size_t place = 0; place < 50; ++place)
        BOOST_CHECK_EQUAL(orders[i].places[orders[i].ranks[place]], place);
  }
}

BOOST_AUTO_TEST_SUITE_END()
