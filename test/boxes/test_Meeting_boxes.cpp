// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Closed and half-open boxes, as intervals of doubles and by their exact ends.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/boxes/Meeting_boxes.h>

BOOST_AUTO_TEST_SUITE(Meeting_boxes)

using namespace test_support;

struct Rectangle
{
  int number;
  double low[2], high[2];
  static int dimension() { return 2; }
  int id() const { return number; }
  double min_coord(int i) const { return low[i]; }
  double max_coord(int i) const { return high[i]; }
};

using Rectangles = std::vector<Rectangle>;
using Traits = internal::Box_members<Rectangle>;
using Boxes = internal::Numbered_boxes<Rectangles, Rectangles, Traits>;
using Meeting = internal::Meeting_boxes<2, Boxes>;

const Traits traits;
const Rectangles none;

bool do_half_open_boxes_meet(const Rectangle& a, const Rectangle& b)
{
  const Rectangles both = {a, b};
  const Boxes boxes(both, none, traits);
  const Meeting meeting(boxes, false);
  BOOST_CHECK_EQUAL(meeting.do_intersect(0, 1), meeting.do_intersect(1, 0));
  return meeting.do_intersect(0, 1);
}

// Along the second axis, the boxes are all the same.
BOOST_AUTO_TEST_CASE(intervals_decide_boxes_of_doubles)
{
  using Limits = std::numeric_limits<double>;
  const std::vector<double> ends = {-Limits::infinity(), Limits::lowest(), -1, -(Limits::min)(),
                                    -Limits::denorm_min(), -0., 0., Limits::denorm_min(),
                                    (Limits::min)(), 1, 1 + Limits::epsilon(), (Limits::max)(),
                                    Limits::infinity()};
  Rectangles rectangles;
  for(const double low : ends)
    for(const double high : ends)
      if(low < high)
        rectangles.push_back({static_cast<int>(rectangles.size()), {low, 0}, {high, 1}});

  const Boxes boxes(rectangles, none, traits);
  for(const bool are_closed : {false, true}) {
    const Meeting meeting(boxes, are_closed);
    BOOST_REQUIRE(meeting.are_exact());
    for(std::size_t i = 0; i < boxes.size(); ++i)
      for(std::size_t j = 0; j < i; ++j) {
        const internal::Interval a = meeting.intervals(i)(0), b = meeting.intervals(j)(0);
        BOOST_REQUIRE(a.low <= a.high);
        BOOST_REQUIRE_EQUAL(a.low <= b.high && b.low <= a.high, meeting.do_intersect(i, j));
      }
  }
}

BOOST_AUTO_TEST_CASE(flat_half_open_boxes_need_the_exact_question)
{
  const Rectangles rectangles = {{0, {0, 0}, {1, 0}}};
  const Boxes boxes(rectangles, none, traits);
  BOOST_CHECK(Meeting(boxes, true).are_exact());
  BOOST_CHECK(!Meeting(boxes, false).are_exact());
  BOOST_CHECK_EQUAL(Meeting(boxes, false).intervals(0)(0).high, 1);
}

BOOST_AUTO_TEST_CASE(a_flat_half_open_box_meets_what_holds_it_inside)
{
  const Rectangle square = {1, {0, 0}, {2, 2}};
  BOOST_CHECK(do_half_open_boxes_meet(square, {2, {1, 1}, {1, 1}}));
  BOOST_CHECK(!do_half_open_boxes_meet(square, {2, {1, 0}, {1, 0}}));
  BOOST_CHECK(!do_half_open_boxes_meet(square, {2, {2, 1}, {2, 1}}));
  BOOST_CHECK(do_half_open_boxes_meet(square, {2, {0, 1}, {0, 1}})); // along the first axis
  BOOST_CHECK(!do_half_open_boxes_meet(square, {0, {0, 1}, {0, 1}}));
}

BOOST_AUTO_TEST_CASE(ids_tell_boxes_and_break_ties)
{
  const Rectangles rectangles = {{7, {0, 0}, {1, 1}}, {5, {1, 0}, {1, 1}}, {7, {2, 2}, {3, 3}}};
  const Boxes boxes(rectangles, none, traits);
  const Meeting meeting(boxes, true);
  BOOST_CHECK(meeting.are_same(0, 2));
  BOOST_CHECK(!meeting.are_same(0, 1));
  BOOST_CHECK(meeting.comes_before(0, 1, 0));
  BOOST_CHECK(meeting.comes_before(1, 0, 1));
  BOOST_CHECK(!meeting.comes_before(0, 1, 1));
}

BOOST_AUTO_TEST_SUITE_END()
