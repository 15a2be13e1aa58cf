// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the public functions promise for objects that are searched by their boxes: those of traits
// with intervals, kernel objects, and balls. What callbacks and progress may do, and the order of
// reports, is in test_faults and test_progress; what is refused, in test_refusals.

#include "support/interval_traits.h"

#include <CGAL/Thick_ball_traits_d.h>

#include <boost/property_map/function_property_map.hpp>

using namespace test_support;

namespace {

// One type of callback, because compilers make a search for each.
using Callback = std::function<bool(std::size_t, std::size_t)>;

Callback collector(Pairs& pairs)
{
  return [&](std::size_t i, std::size_t j) {
    pairs.emplace_back(i, j);
    return true;
  };
}

// Some boxes of a lattice, most of them short, a few as long as the scene.
Number_boxes some_boxes(int dimension, std::size_t size)
{
  Generator random(size);
  const double side = std::floor(6 * std::pow(size, 1. / dimension));
  Number_boxes boxes(size);
  for(Number_box& box : boxes)
    for(int axis = 0; axis < dimension; ++axis) {
      const double low = below(random, static_cast<std::uint64_t>(side));
      box[axis] = {low, low + (random() % 100 == 0 ? side : below(random, 7))};
    }
  return boxes;
}

template <int... Dimensions>
void check_fixed_dimensions(std::size_t size)
{
  Call_count calls = 0;
  (check_colored(some_boxes(Dimensions, size), Fixed_interval_traits<Dimensions>(calls)), ...);
}

BOOST_AUTO_TEST_CASE(archetype_traits_are_enough_in_any_dimension)
{
  for(const int dimension : {1, 2, 3, 4, 5, 8})
    for(const std::size_t size : {0, 1, 2, 50, 400, 3000}) {
      Call_count calls = 0;
      check_colored(some_boxes(dimension, size), Interval_traits(dimension, calls));
    }
}

BOOST_AUTO_TEST_CASE(boxes_may_have_any_sizes)
{
  for(int dimension = 1; dimension <= 6; ++dimension) {
    Call_count calls = 0;
    check_colored(boxes_of_all_sizes(dimension, 2000), Interval_traits(dimension, calls));
  }
}

BOOST_AUTO_TEST_CASE(dimension_may_be_fixed_when_compiled)
{
  for(const std::size_t size : {0, 1, 50, 1000})
    check_fixed_dimensions<1, 2, 3, 4>(size);
}

BOOST_AUTO_TEST_CASE(predicate_is_asked_once_about_boxes_that_meet_and_about_no_others)
{
  for(const int dimension : {1, 2, 3, 4}) {
    const Number_boxes boxes = some_boxes(dimension, 3000);
    Call_count calls = 0;
    pairs_by_traits(boxes, Interval_traits(dimension, calls));
    BOOST_CHECK_EQUAL(calls, all_meeting_pairs(boxes, dimension).size());
  }
}

// Lines, half planes, the plane; and a few boxes.
BOOST_AUTO_TEST_CASE(intervals_may_be_infinite)
{
  for(const std::size_t size : {40, 1000}) {
    Generator random(7);
    Number_boxes boxes = some_boxes(3, size);
    for(Number_box& box : boxes)
      for(int axis = 0; axis < 3; ++axis) {
        if(random() % 10 == 0)
          box[axis].low = -infinity;
        if(random() % 10 == 0)
          box[axis].high = infinity;
      }
    boxes[5][0] = {infinity, infinity};
    boxes[6][0] = {-infinity, -infinity};
    boxes[7].fill({-infinity, infinity});
    Call_count calls = 0;
    check_colored(boxes, Fixed_interval_traits<3>(calls));
  }
}

struct Checking_traits : Interval_traits
{
  using Interval_traits::Interval_traits;
  void check(const Colored_box& box, std::size_t position) const
  {
    if(box.box()[0].low < 0)
      throw std::out_of_range("Object " + std::to_string(position) + " is not allowed.");
  }
};

BOOST_AUTO_TEST_CASE(traits_check_objects_before_intervals_are_read)
{
  Number_boxes boxes = some_boxes(3, 200);
  boxes[7][1] = {1, 0};
  boxes[150][0].low = -1;
  Call_count calls = 0;
  const Callback fail = [](std::size_t, std::size_t) {
    BOOST_ERROR("reported before all was checked");
    return true;
  };
  BOOST_CHECK_EQUAL(refusal<std::out_of_range>([&] {
    CGAL::thick_self_intersection_d(colored(boxes), fail,
                                    CGAL::parameters::geom_traits(Checking_traits(3, calls)));
  }), "Object 150 is not allowed.");
}

// The objects are made when they are asked for, from numbers in a list.
BOOST_AUTO_TEST_CASE(point_map_may_make_temporary_objects)
{
  const Number_boxes boxes = some_boxes(2, 500);
  std::list<std::size_t> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const Pairs expected = all_meeting_pairs(boxes, 2);
  Pairs found;
  const Callback collect = collector(found);

  using Kernel = CGAL::Simple_cartesian<double>;
  using Rectangle = Kernel::Iso_rectangle_2;
  const auto rectangle = [&](std::size_t i) {
    const Number_box& box = boxes[i];
    return Rectangle(box[0].low, box[1].low, box[0].high, box[1].high);
  };
  const auto rectangles = boost::make_function_property_map<std::size_t, Rectangle>(rectangle);
  CGAL::thick_self_intersection_d(numbers, collect, CGAL::parameters::point_map(rectangles));
  BOOST_CHECK(sorted(found) == expected);

  // Balls that touch or overlap if their centers on a line are as near as their radii allow.
  using Ball = std::pair<Kernel::Point_2, double>;
  const auto ball = [&](std::size_t i) {
    const internal::Interval& interval = boxes[i][0];
    return Ball(Kernel::Point_2((interval.low + interval.high) / 2, 0), interval.length() / 2);
  };
  std::vector<Ball> balls;
  for(const std::size_t number : numbers)
    balls.push_back(ball(number));
  found.clear();
  CGAL::thick_self_intersection_d(
    numbers, collect,
    CGAL::parameters::point_map(boost::make_function_property_map<std::size_t, Ball>(ball))
      .geom_traits(CGAL::Thick_ball_traits_d<Kernel::Point_2>(balls)));
  BOOST_CHECK(sorted(found) == all_meeting_pairs(boxes, 1));
}

// Boxes of doubles do not enclose them usefully, so they take the recursive route.
BOOST_AUTO_TEST_CASE(balls_beyond_the_range_of_doubles_are_searched_exactly)
{
  using Number = CGAL::Exact_rational;
  using Point = CGAL::Simple_cartesian<Number>::Point_2;
  Number far = 1;
  for(int i = 0; i < 1100; ++i)
    far *= 2;
  std::vector<std::pair<Point, Number>> balls;
  for(int i = 0; i < 100; ++i)
    balls.emplace_back(Point(Number(far * (i % 10)), Number(far * (i / 10))),
                       Number(i % 2 ? far / 2 : Number(far / 2 + 1)));
  Pairs expected; // neighbors in a row are of either kind, those in a column of one kind
  for(std::size_t i = 0; i < 100; ++i) {
    if(i % 10 != 9)
      expected.emplace_back(i, i + 1);
    if(i < 90)
      expected.emplace_back(i, i + 10);
  }
  const CGAL::Thick_ball_traits_d<Point> traits(balls);
  check_pairs("balls", expected, reported([&](auto collect) {
    CGAL::thick_self_intersection_d(balls, collect, CGAL::parameters::geom_traits(traits));
  }));
}

} // namespace
