// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The lanes of each instruction set against all pairs of boxes, and against the plain lanes.

#include "support/instruction_sets.h"
#include "support/number_boxes.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(meeting_boxes)

using namespace test_support;

// The pairs of a box of one run and a candidate in the other one that meet, in the order of lanes,
// as positions.
template <class Lanes, int Axes>
Pairs collected(Lanes, const internal::Box_order<Axes>& order)
{
  Pairs pairs;
  internal::Found_pairs found;
  for(std::size_t set = 0; set < order.set_count(); ++set) {
    const auto& a = order.run(set);
    const auto& b = order.candidates(set);
    const auto add = [&](internal::Place i, internal::Place j) {
      pairs.emplace_back(std::minmax<std::size_t>(a.positions[i], b.positions[j]));
    };
    const auto flush = [&] {
      for(internal::Place row = 0; row < found.row_count; ++row)
        for(internal::Place lane = 0; lane < internal::lanes; ++lane)
          add(found.rows[row].i, found.rows[row].j + lane);
      for(internal::Place c = 0; c < found.count; ++c)
        add(found.pairs[c].i, found.pairs[c].j);
      found.count = 0;
      found.row_count = 0;
      return true;
    };
    Lanes::collect_meeting(a, b, found, internal::Flush(flush));
    flush();
  }
  return pairs;
}

template <class Lanes, int Axes>
void check_lanes(Lanes set, const internal::Piece<internal::Piece_box<Axes>>& piece,
                 const Number_boxes& boxes)
{
  for(const double max_bucket_pairs : {0., 1e9}) {
    Box_tuning tuning;
    tuning.max_bucket_pairs = max_bucket_pairs;
    internal::Box_order<Axes> order;
    order.set(piece, 0, tuning);
    const Pairs found = collected(set, order);
    std::optional<std::size_t> first_set_size;
    if(piece.set_count() == 2)
      first_set_size = piece[0].size();
    const Pairs_difference difference
      = compare(all_meeting_pairs(boxes, Axes, first_set_size), found);
    BOOST_CHECK_MESSAGE(difference.empty(), difference);
    BOOST_CHECK(found == collected(internal::lanes_plain::Lanes(), order)); // in the same order
  }
}

// Runs of no, one and several rows of lanes; and long ones, whose pairs are flushed.
template <int Axes, class Lanes>
void check_lanes_of_boxes(Lanes set)
{
  for(unsigned int seed = 0; seed < 300; ++seed) {
    Generator random(seed);
    const std::size_t size = seed % 50 == 0 ? 400 : 1 + seed % 50;
    const Number_boxes boxes = structured_boxes(random, Axes, size);
    const Number_objects objects(boxes, Axes);
    const auto check = [&](const auto&, const auto& piece) { check_lanes(set, piece, boxes); };
    BOOST_TEST_CONTEXT("seed " << seed << ", " << Axes << " axes")
    {
      with_piece<Axes>(objects, std::nullopt, check);
      with_piece<Axes>(objects, random() % (size + 1), check);
    }
  }
}

BOOST_AUTO_TEST_CASE(all_lanes_collect_the_meeting_pairs_in_the_same_order)
{
  with_all_lanes([](auto set) {
    check_lanes_of_boxes<2>(set);
    check_lanes_of_boxes<3>(set);
    check_lanes_of_boxes<4>(set);
  });
}

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
