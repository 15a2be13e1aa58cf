// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Boxes that meet along the sweep axis are candidates once, whether boxes are in the order of their
// buckets or sorted.

#include "support/number_boxes.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(Box_order)

using namespace test_support;

// Structured boxes, or boxes most of which begin at one place.
Number_boxes some_boxes(Generator& random, std::size_t size)
{
  Number_boxes boxes = structured_boxes(random, 3, size);
  if(random() % 2)
    for(std::size_t i = 0; i < size; ++i)
      if(random() % 8)
        for(internal::Interval& interval : boxes[i])
          interval = {0, interval.high < 0 ? 0 : interval.high};
  return boxes;
}

// The columns hold the boxes, the column of the sweep axis comes first, and NaN follows.
template <class Run>
void check_columns(const Run& run, const Number_boxes& boxes, int sweep_axis)
{
  const int axes[3] = {sweep_axis, sweep_axis == 1 ? 0 : 1, sweep_axis == 2 ? 0 : 2};
  for(internal::Place i = run.first; i < run.last; ++i)
    for(int column = 0; column < 3; ++column) {
      BOOST_CHECK_EQUAL(run.low[column][i], boxes[run.positions[i]][axes[column]].low);
      BOOST_CHECK_EQUAL(run.high[column][i], boxes[run.positions[i]][axes[column]].high);
    }
  for(internal::Place lane = 0; lane < internal::lanes; ++lane)
    for(int column = 0; column < 3; ++column)
      BOOST_CHECK(std::isnan(run.low[column][run.last + lane])
                  && std::isnan(run.high[column][run.last + lane]));
}

// Counts how often each pair is a box and its candidate.
void check_candidates(const internal::Piece<internal::Piece_box<3>>& piece,
                      const Number_boxes& boxes, int sweep_axis, double max_bucket_pairs)
{
  Box_tuning tuning;
  tuning.max_bucket_pairs = max_bucket_pairs;
  internal::Box_order<3> order;
  order.set(piece, sweep_axis, tuning);
  std::map<Pair, int> counts;
  std::uint64_t candidates = 0;
  for(std::size_t set = 0; set < piece.set_count(); ++set) {
    const auto& a = order.run(set);
    const auto& b = order.candidates(set);
    BOOST_CHECK_EQUAL(a.last - a.first, piece[set].size());
    check_columns(a, boxes, sweep_axis);
    for(internal::Place i = a.first; i < a.last; ++i)
      for(internal::Place j = a.begins[i]; j < a.ends[i]; ++j, ++candidates)
        ++counts[std::minmax<std::size_t>(a.positions[i], b.positions[j])];
  }
  BOOST_CHECK_EQUAL(order.candidate_count(), candidates);

  std::uint64_t meeting = 0;
  const std::size_t first_set_size = piece[0].size();
  for(std::size_t i = 0; i < first_set_size; ++i)
    for(std::size_t j = piece.set_count() == 1 ? i + 1 : first_set_size; j < boxes.size(); ++j) {
      const bool meet = intervals_meet(boxes[i][sweep_axis], boxes[j][sweep_axis]);
      meeting += meet;
      const int count = counts[Pair(i, j)];
      BOOST_CHECK_MESSAGE(count <= 1 && (!meet || count == 1), i << " and " << j);
    }
  if(max_bucket_pairs == 0) // sorted
    BOOST_CHECK_EQUAL(candidates, meeting);
}

BOOST_AUTO_TEST_CASE(boxes_that_meet_along_the_sweep_axis_are_candidates_once)
{
  for(unsigned int seed = 0; seed < 3000; ++seed) {
    Generator random(seed);
    const std::size_t size = 2 + random() % 40;
    const Number_boxes boxes = some_boxes(random, size);
    const int sweep_axis = static_cast<int>(seed % 3);
    BOOST_TEST_CONTEXT("seed " << seed)
    for(const double max_bucket_pairs : {0., 2., 1e9}) {
      const Number_objects objects(boxes, 3);
      const auto check = [&](const auto&, const auto& piece) {
        check_candidates(piece, boxes, sweep_axis, max_bucket_pairs);
      };
      with_piece<3>(objects, std::nullopt, check);
      with_piece<3>(objects, random() % (size + 1), check);
    }
  }
}

BOOST_AUTO_TEST_CASE(copies_are_noted)
{
  std::vector<internal::Piece_box<3>> boxes(4);
  for(internal::Place i = 0; i < 4; ++i)
    boxes[i] = {{0, 0, 0}, {1, 1, 1}, i, i == 3 ? 4u : 0u};
  internal::Box_order<3> order;
  auto* const first = boxes.data();
  order.set({{first, first + 2}, {first + 2, first + 4}}, 0);
  BOOST_CHECK(!order.run(0).has_copies);
  BOOST_CHECK(order.run(1).has_copies);
  BOOST_CHECK_EQUAL(order.run(1).sides[0] + order.run(1).sides[1], 4u);
}

// A bucket that holds nearly all boxes would make all of them candidates of each other.
BOOST_AUTO_TEST_CASE(crowded_lower_ends_are_sorted)
{
  Number_boxes boxes(1000);
  for(std::size_t i = 0; i < boxes.size(); ++i)
    boxes[i][0] = {1e-6 * static_cast<double>(i), 1e-6 * static_cast<double>(i)};
  boxes[0][0] = {1e9, 1e9};
  const Number_objects objects(boxes, 3);
  with_piece<3>(objects, std::nullopt, [&](const auto&, const auto& piece) {
    check_candidates(piece, boxes, 0, Box_tuning().max_bucket_pairs);
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
