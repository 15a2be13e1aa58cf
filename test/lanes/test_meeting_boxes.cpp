// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lanes that look for boxes that meet stop when they are told, and blocks divide a run of boxes.
// The lanes of each instruction set find the right pairs in test_Box_route.cpp.

#include "support/instruction_sets.h"
#include "support/number_boxes.h"

BOOST_AUTO_TEST_SUITE(meeting_boxes)

using namespace test_support;

// Of 200 boxes all or every other one meet, so that they are found in rows or one by one.
template <class Lanes>
void check_stop(Lanes set, bool do_all_meet)
{
  std::vector<internal::Piece_box<2>> boxes(200, {{0, 0}, {1, 1}, 0, 0}); // 19900 pairs
  for(std::size_t i = 1; i < boxes.size() && !do_all_meet; i += 2)
    boxes[i] = {{0, 2}, {1, 3}, 0, 0};
  internal::Box_order<2> order;
  using Piece = internal::Piece<internal::Piece_box<2>>;
  order.set(Piece({boxes.data(), boxes.data() + boxes.size()}), 0);
  internal::Found_pairs found;
  int calls = 0;
  const auto stop = [&] {
    ++calls;
    BOOST_CHECK(found.count >= internal::Found_pairs::capacity
                || found.row_count == internal::Found_pairs::row_capacity);
    BOOST_CHECK_EQUAL(found.row_count != 0, do_all_meet);
    found.count = 0;
    found.row_count = 0;
    return false;
  };
  set.collect_meeting(order.run(0), order.run(0), found, internal::Flush(stop));
  BOOST_CHECK_EQUAL(calls, 1);
}

BOOST_AUTO_TEST_CASE(lanes_stop_when_told)
{
  for(const bool do_all_meet : {true, false})
    with_all_lanes([&](auto set) { check_stop(set, do_all_meet); });
}

// Each block starts from boxes of its own, and all of them together from all boxes.
BOOST_AUTO_TEST_CASE(blocks_of_a_run_divide_its_boxes)
{
  internal::Box_run<2> run = {};
  run.last = 1000;
  for(const internal::Place count : {1, 3, 7, 1000, 1500}) {
    internal::Place end = 0;
    for(internal::Place index = 0; index < count; ++index) {
      BOOST_CHECK_EQUAL(run.block(index, count).first, end);
      end = run.block(index, count).last;
    }
    BOOST_CHECK_EQUAL(end, 1000u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
