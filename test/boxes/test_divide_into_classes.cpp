// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Each box is in one class: that of the axes along which it is long.

#include "support/number_boxes.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(divide_into_classes)

using namespace test_support;
using Box = internal::Piece_box<3>;

bool is_long(const Box& box, int axis, const std::array<double, 3>& lengths)
{
  return box.high[axis] - box.low[axis] > lengths[axis];
}

BOOST_AUTO_TEST_CASE(classes_divide_the_boxes_by_the_axes_along_which_they_are_long)
{
  Generator random(1);
  std::vector<Box> boxes(500);
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    for(int axis = 0; axis < 3; ++axis) {
      boxes[i].low[axis] = random() % 50 == 0 ? -infinity : below(random, 10);
      boxes[i].high[axis] = boxes[i].low[axis] + below(random, 5);
    }
    boxes[i].position = static_cast<internal::Place>(i);
  }
  const std::vector<Box> before = boxes;
  const std::array<double, 3> lengths = {1, 2, 0};
  const auto classes
    = internal::divide_into_classes<Box>({boxes.data(), boxes.data() + boxes.size()}, lengths);
  std::vector<int> seen(boxes.size(), 0);
  BOOST_CHECK_EQUAL(classes.size(), 8u);
  for(const auto& span : classes)
    for(const Box* box = span.first; box != span.last; ++box) {
      ++seen[box->position];
      BOOST_CHECK(box->low == before[box->position].low);
      for(int axis = 0; axis < 3; ++axis)
        BOOST_CHECK_EQUAL(is_long(*box, axis, lengths), is_long(*span.first, axis, lengths));
    }
  BOOST_CHECK(std::count(seen.begin(), seen.end(), 1) == 500);
}

BOOST_AUTO_TEST_CASE(classes_without_boxes_are_left_out)
{
  BOOST_CHECK(internal::divide_into_classes<Box>({nullptr, nullptr}, {1, 1, 1}).empty());
  std::vector<Box> boxes(2);
  boxes[0].high = {2, 0, 0};
  boxes[1].high = {0, 0, 2};
  BOOST_CHECK_EQUAL(
    internal::divide_into_classes<Box>({boxes.data(), boxes.data() + 2}, {1, 1, 1}).size(), 2u);
}

BOOST_AUTO_TEST_SUITE_END()
