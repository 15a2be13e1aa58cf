// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Candidates are few in crowds, and a sample shows how many of them are pairs. That all boxes that
// meet are candidates once is left to test_Box_route.cpp.

#include "support/number_boxes.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(Box_order)

using namespace test_support;

// A bucket that holds nearly all boxes would make all of them candidates of each other.
BOOST_AUTO_TEST_CASE(crowded_lower_ends_are_sorted)
{
  Number_boxes boxes(1000);
  for(std::size_t i = 0; i < boxes.size(); ++i)
    boxes[i][0] = {1e-6 * static_cast<double>(i), 1e-6 * static_cast<double>(i)};
  boxes[0][0] = {1e9, 1e9};
  const Number_objects objects(boxes, 3);
  with_piece<3>(objects, std::nullopt, [&](const auto&, const auto& piece) {
    internal::Box_order<3> order;
    order.set(piece, 0);
    BOOST_CHECK_EQUAL(order.candidate_count(), 0u);
  });
}

// All boxes meet along axis 0. Those of 512 candidates at equal steps meet all boxes, and no others
// meet.
BOOST_AUTO_TEST_CASE(candidates_at_equal_steps_do_not_hide_that_few_are_pairs)
{
  const std::size_t size = 1 << 15;
  const double step = size * (size - 1.) / 2 / internal::crowd_sample;
  std::vector<internal::Piece_box<2>> boxes;
  for(internal::Place i = 0; i < size; ++i)
    boxes.push_back({{double(i), 2. * i}, {size, 2. * i + 1}, i, 0});
  double passed = 0; // candidates of boxes before i
  double next = step / 2;
  for(std::size_t i = 0; i < size; passed += static_cast<double>(size - ++i))
    for(; next < passed + static_cast<double>(size - i - 1); next += step)
      for(const std::size_t j : {i, i + 1 + static_cast<std::size_t>(next - passed)}) {
        boxes[j].low[1] = 0;
        boxes[j].high[1] = 2 * size;
      }
  internal::Box_order<2> order;
  order.set(internal::Piece<internal::Piece_box<2>>({boxes.data(), boxes.data() + size}), 0);
  BOOST_CHECK_EQUAL(order.candidate_count(), size * (size - 1) / 2);
  BOOST_CHECK_LT(order.share_of_pairs([](internal::Place, internal::Place) { return true; }), .1);
}

BOOST_AUTO_TEST_SUITE_END()
