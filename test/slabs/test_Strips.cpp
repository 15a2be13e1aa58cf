// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Strips keep the points that are appended, and borders the points in an interval, in order.

#include "support/instruction_sets.h"
#include "support/point_source.h"
#include "support/unit_test.h"

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

void check_end(double x, internal::Place) { BOOST_CHECK(std::isnan(x)); }
void check_end(std::int32_t x, internal::Place lane)
{
  BOOST_CHECK_EQUAL(x, internal::end_of_run<std::int32_t>(lane));
}

// The strips are those of `expected` that are not empty. Each run ends in points near nothing.
template <class Point>
void check_strips(const internal::Strips<Point>& strips,
                  const std::vector<std::vector<Point>>& expected)
{
  std::size_t size = 0;
  auto strip = strips.strips().begin();
  for(const auto& points : expected) {
    if(points.empty())
      continue;
    size += points.size();
    BOOST_REQUIRE(strip != strips.strips().end());
    const typename Point::Run run = strips.run(*strip++);
    BOOST_REQUIRE_EQUAL(run.size, points.size());
    for(std::size_t i = 0; i < points.size(); ++i) {
      BOOST_CHECK_EQUAL(run.positions[i], points[i].position);
      for(std::size_t axis = 0; axis < Point::dimension; ++axis)
        BOOST_CHECK_EQUAL(run.x[axis][i], points[i].x[axis]);
    }
    for(internal::Place lane = 0; lane < internal::lanes; ++lane)
      check_end(run.x[0][run.size + lane], lane);
  }
  BOOST_CHECK(strip == strips.strips().end());
  BOOST_CHECK_EQUAL(strips.size(), size);
}

// The boxes hold the points.
template <class Point>
void check_boxes(const internal::Strips<Point>& strips)
{
  for(const auto& strip : strips.strips()) {
    const typename Point::Run run = strips.run(strip);
    for(int axis = 0; axis < Point::dimension; ++axis)
      for(internal::Place i = 0; i < run.size; ++i) {
        const double x = run.x[static_cast<std::size_t>(axis)][i];
        const internal::Interval& box = strip.box[static_cast<std::size_t>(axis)];
        BOOST_CHECK(box.low <= x && x <= box.high);
        BOOST_CHECK(strips.interval(axis).low <= x && x <= strips.interval(axis).high);
      }
  }
}

template <class Point>
void check_borders()
{
  Random random(1);
  for(int repetition = 0; repetition < 200; ++repetition) {
    const auto points = random_strips<Point>(random);
    const auto strips = make_strips<Point>(points);
    check_strips<Point>(strips, points);
    check_boxes<Point>(strips);

    const int axis = static_cast<int>(random.below(Point::dimension));
    const double low = static_cast<double>(random.below(10));
    const internal::Interval interval = {low, low + static_cast<double>(random.below(4))};
    auto kept = points;
    for(auto& strip : kept)
      strip.erase(std::remove_if(strip.begin(), strip.end(), [&](const auto& p) {
                    const double x = p.x[static_cast<std::size_t>(axis)];
                    return x < interval.low || interval.high < x;
                  }), strip.end());
    internal::Strips<Point> border;
    border.reset(strips.size(), static_cast<internal::Place>(strips.strips().size()));
    for(const auto& strip : strips.strips())
      border.append_border(strips, strip, axis, interval);
    check_strips<Point>(border, kept);
    check_boxes<Point>(border);
  }
}

BOOST_AUTO_TEST_CASE(borders_keep_the_points_in_an_interval_2)
{
  check_borders<Doubles<2>>();
  check_borders<Integers<2>>();
}
BOOST_AUTO_TEST_CASE(borders_keep_the_points_in_an_interval_3)
{
  check_borders<Doubles<3>>();
  check_borders<Integers<3>>();
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

BOOST_AUTO_TEST_CASE(strips_are_forgotten_when_room_is_made)
{
  Random random(2);
  auto strips = make_strips<Doubles<2>>(random_strips<Doubles<2>>(random));
  const std::vector<std::vector<Doubles<2>>> other = {{{{0.5, 0.25}, 7}}, {}};
  strips.reset(1, 2);
  BOOST_CHECK(strips.strips().empty());
  BOOST_CHECK_EQUAL(strips.size(), 0u);
  for(const auto& strip : other)
    strips.append(strip.data(), strip.data() + strip.size(), internal::Point_sets());
  check_strips<Doubles<2>>(strips, other);
  BOOST_CHECK_EQUAL(strips.interval(1).low, 0.25);
  BOOST_CHECK_EQUAL(strips.interval(1).high, 0.25);
}

BOOST_AUTO_TEST_SUITE_END()
