// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lanes of each instruction set copy the points of a strip in an interval, in order. That
// strips and their borders hold the points that they should is left to test_Slab_route.cpp.

#include "support/instruction_sets.h"
#include "support/point_source.h"

#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>

BOOST_AUTO_TEST_SUITE(Strips)

using namespace test_support;

template <int Dimension>
using Doubles = internal::Slab_point<Dimension, double>;
template <int Dimension>
using Integers = internal::Slab_point<Dimension, std::int32_t>;

// Strips of points on a coarse lattice, sorted along axis 0; some are empty.
template <class Point>
std::vector<std::vector<Point>> random_strips(Random& random)
{
  std::vector<std::vector<Point>> strips(1 + random.below(8));
  internal::Place position = 0;
  for(auto& strip : strips) {
    for(std::size_t size = random.below(20); size > 0; --size) {
      Point p;
      for(auto& x : p.x)
        x = static_cast<typename Point::Number>(random.below(10));
      p.position = position++;
      strip.push_back(p);
    }
    std::sort(strip.begin(), strip.end(), [](const auto& p, const auto& q) {
      return p.x[0] < q.x[0];
    });
  }
  return strips;
}

template <class Point>
internal::Strips<Point>
make_strips(const std::vector<std::vector<Point>>& points)
{
  std::size_t size = 0;
  for(const auto& strip : points)
    size += strip.size();
  internal::Strips<Point> strips;
  strips.reset(static_cast<internal::Place>(size), static_cast<internal::Place>(points.size()));
  for(const auto& strip : points)
    strips.append(strip.data(), strip.data() + strip.size(), internal::Point_sets());
  return strips;
}

// A point is copied if its coordinate along the axis is in the interval, with all coordinates.
template <class Point, class Lanes>
void check_copies(const internal::Strips<Point>& strips, const Lanes& set, Random& random)
{
  using Number = typename Point::Number;
  const std::size_t axis = random.below(Point::dimension);
  const Number low = static_cast<Number>(random.below(10));
  const Number high = low + static_cast<Number>(random.below(4));
  for(const auto& strip : strips.strips()) {
    const typename Point::Run run = strips.run(strip);
    BOOST_CHECK_GT(run.size, 0u);
    std::array<std::vector<Number>, Point::dimension> columns;
    std::array<Number*, Point::dimension> x;
    for(std::size_t c = 0; c < columns.size(); ++c) {
      columns[c].resize(run.size + internal::lanes);
      x[c] = columns[c].data();
    }
    std::vector<internal::Place> positions(run.size + internal::lanes);
    const internal::Place count
      = set.copy_between(run, static_cast<int>(axis), low, high, x, positions.data());
    internal::Place expected = 0;
    for(internal::Place i = 0; i < run.size; ++i)
      if(low <= run.x[axis][i] && run.x[axis][i] <= high) {
        BOOST_CHECK_EQUAL(positions[expected], run.positions[i]);
        for(std::size_t c = 0; c < columns.size(); ++c)
          BOOST_CHECK_EQUAL(columns[c][expected], run.x[c][i]);
        ++expected;
      }
    BOOST_CHECK_EQUAL(count, expected);
  }
}

BOOST_AUTO_TEST_CASE(lanes_copy_the_points_in_an_interval)
{
  with_all_lanes([](auto set) {
    Random random(3);
    for(int repetition = 0; repetition < 100; ++repetition) {
      check_copies(make_strips(random_strips<Doubles<2>>(random)), set, random);
      check_copies(make_strips(random_strips<Integers<3>>(random)), set, random);
    }
  });
}

// Points of the border of a column have a strip of their own. Without such points there is none,
// and no place for one: most strips in space have none.
BOOST_AUTO_TEST_CASE(strips_have_a_border_if_there_are_points_in_it)
{
  for(const internal::Place border_size : {0u, 1u, 3u, 5u}) {
    std::vector<Doubles<3>> points = slab_points<3>(uniform_points(3, 5, 0, 1, 1));
    for(internal::Place i = 0; i < border_size; ++i)
      points[i].position |= internal::Point_sets::border_bit;
    internal::Strips<Doubles<3>> strips;
    strips.reset(5, 2);
    strips.append(points.data(), points.data() + 5, {internal::Point_sets().first_size, true});
    BOOST_CHECK_EQUAL(strips.size(), 5u);
    BOOST_CHECK_EQUAL(strips.own_size(), 5 - border_size);
    BOOST_CHECK_EQUAL(strips.place_count(), 5 + (border_size == 0 ? 1 : 2) * internal::lanes);
  }
}

BOOST_AUTO_TEST_SUITE_END()
