// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Each box is in one class: that of the axes along which it is long.

#include "support/number_boxes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

BOOST_AUTO_TEST_SUITE(Box_classes)

using namespace test_support;
using Box = internal::Piece_box<3>;

BOOST_AUTO_TEST_CASE(classes_divide_the_boxes_by_the_axes_along_which_they_are_long)
{
  const double infinity = std::numeric_limits<double>::infinity();
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
  const internal::Box_classes<Box> classes({boxes.data(), boxes.data() + boxes.size()}, lengths);
  std::vector<int> seen(boxes.size(), 0);
  for(internal::Place number = 0; number < 8; ++number) {
    BOOST_CHECK_GT(classes[number].size(), 10u);
    for(const Box* box = classes[number].first; box != classes[number].last; ++box) {
      ++seen[box->position];
      BOOST_CHECK(box->low == before[box->position].low);
      for(int axis = 0; axis < 3; ++axis)
        BOOST_CHECK_EQUAL(box->high[axis] - box->low[axis] > lengths[axis],
                          (number >> axis & 1) == 1);
    }
  }
  BOOST_CHECK(std::count(seen.begin(), seen.end(), 1) == 500);
}

BOOST_AUTO_TEST_CASE(no_boxes_have_empty_classes)
{
  const internal::Box_classes<Box> classes({nullptr, nullptr}, {1, 1, 1});
  for(internal::Place number = 0; number < 8; ++number)
    BOOST_CHECK_EQUAL(classes[number].size(), 0u);
}

BOOST_AUTO_TEST_SUITE_END()
