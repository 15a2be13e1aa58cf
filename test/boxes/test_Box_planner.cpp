// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Plans: a sweep along the axis along which few boxes meet, and a cut where it saves time.

#include "support/number_boxes.h"
#include "support/unit_test.h"

BOOST_AUTO_TEST_SUITE(Box_planner)

using namespace test_support;

// Boxes of the given lengths that begin anywhere in the unit cube.
Number_boxes uniform_boxes(std::size_t size, const std::vector<double>& lengths)
{
  Generator random(size);
  Number_boxes boxes(size);
  for(Number_box& box : boxes)
    for(std::size_t axis = 0; axis < lengths.size(); ++axis) {
      const double low = below(random, 1 << 30) / (1 << 30);
      box[axis] = {low, low + lengths[axis]};
    }
  return boxes;
}

template <int Axes>
internal::Box_plan<Axes> plan_of(const Number_boxes& boxes,
                           const Box_tuning& tuning = Box_tuning(),
                           std::optional<std::size_t> first_set_size = std::nullopt)
{
  const Number_objects objects(boxes, Axes);
  return with_piece<Axes>(objects, first_set_size, [&](const auto&, const auto& piece) {
    return internal::Box_planner<Axes>(tuning).plan(piece, 16384);
  });
}

BOOST_AUTO_TEST_CASE(small_boxes_are_cut_across_the_sweep_axis)
{
  for(const std::optional<std::size_t> first_set_size :
      {std::optional<std::size_t>(), std::optional<std::size_t>(3000)}) {
    const internal::Box_plan<2> plan
      = plan_of<2>(uniform_boxes(10000, {0.01, 0.01}), Box_tuning(), first_set_size);
    BOOST_CHECK_EQUAL(plan.cut_axis, 1 - plan.sweep_axis);
    BOOST_CHECK_GE(plan.piece_count, 8u);
    BOOST_CHECK_LE(plan.piece_count, 64u); // a hundred would copy each box
    BOOST_CHECK_LT(plan.range.low, 0.01);
    BOOST_CHECK_GT(plan.range.high, 0.99);
    BOOST_CHECK_LT(plan.candidates, 20); // without the cut, 100
    BOOST_CHECK_GT(plan.candidates, 2);
  }
}

BOOST_AUTO_TEST_CASE(sweep_axis_is_the_one_along_which_boxes_are_short)
{
  for(int axis = 0; axis < 3; ++axis) {
    std::vector<double> lengths(3, 0.5);
    lengths[static_cast<std::size_t>(axis)] = 0.001;
    BOOST_CHECK_EQUAL(plan_of<3>(uniform_boxes(1000, lengths)).sweep_axis, axis);
  }
}

// Every third box begins anywhere, and the others begin in one place along axis 0.
BOOST_AUTO_TEST_CASE(boxes_of_one_kind_at_equal_steps_do_not_mislead_the_plan)
{
  Number_boxes boxes = uniform_boxes(3 * 16384, {1e-6, 1e-6});
  for(std::size_t i = 0; i < boxes.size(); ++i)
    if(i % 3 != 0)
      boxes[i][0] = {0.5, 0.5};
  BOOST_CHECK_EQUAL(plan_of<2>(boxes).sweep_axis, 1);
}

BOOST_AUTO_TEST_CASE(candidates_are_estimated)
{
  const internal::Box_plan<2> plan = plan_of<2>(uniform_boxes(10000, {0.02, 5}));
  BOOST_CHECK_EQUAL(plan.cut_axis, -1); // each box would be in all pieces
  BOOST_CHECK_CLOSE(plan.candidates, 200, 5);
}

// Rows and columns that begin on a diagonal meet along either axis, but not along both.
BOOST_AUTO_TEST_CASE(sample_shows_a_crowd_without_pairs)
{
  Number_boxes boxes(20000);
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    const double x = static_cast<double>(i);
    boxes[i][i % 2] = {x, x + 10000};
    boxes[i][1 - i % 2] = {x, x};
  }
  const internal::Box_plan<2> crowd = plan_of<2>(boxes);
  BOOST_CHECK_GT(crowd.candidates, 2000);
  BOOST_CHECK_LT(crowd.pair_share, 0.01);
  BOOST_CHECK_EQUAL(plan_of<2>(Number_boxes(20000), Box_tuning(), 5000).pair_share, 1);
  for(Number_box& box : boxes)
    box[1] = {0, 0};
  BOOST_CHECK_GT(plan_of<2>(boxes).pair_share, 0.9);
}

BOOST_AUTO_TEST_CASE(identical_boxes_are_not_cut)
{
  const internal::Box_plan<3> plan = plan_of<3>(Number_boxes(10000));
  BOOST_CHECK_EQUAL(plan.cut_axis, -1);
  Number_boxes equal(10000);
  for(Number_box& box : equal)
    box.fill({1, 2});
  BOOST_CHECK_EQUAL(plan_of<3>(equal).cut_axis, -1);
}

BOOST_AUTO_TEST_CASE(few_boxes_are_not_cut)
{
  const Number_boxes boxes = uniform_boxes(31, {0.2, 0.01});
  Box_tuning tuning;
  tuning.move_cost = tuning.box_cost = tuning.piece_cost = 0;
  BOOST_CHECK_EQUAL(plan_of<2>(boxes, tuning).cut_axis, -1);
  tuning.min_boxes_per_piece = 8;
  BOOST_CHECK_EQUAL(plan_of<2>(boxes, tuning).cut_axis, 0);
}

BOOST_AUTO_TEST_CASE(what_a_cut_costs_decides_about_it)
{
  const Number_boxes boxes = uniform_boxes(1000, {0.02, 0.02});
  Box_tuning tuning;
  const internal::Box_plan<2> usual = plan_of<2>(boxes, tuning);
  tuning.candidate_cost = 100;
  BOOST_CHECK_GE(plan_of<2>(boxes, tuning).piece_count, (std::max)(usual.piece_count, 2u));
  tuning.move_cost = 1e6;
  BOOST_CHECK_EQUAL(plan_of<2>(boxes, tuning).cut_axis, -1);
  tuning.move_cost = 0;
  tuning.piece_cost = 1e9;
  BOOST_CHECK_EQUAL(plan_of<2>(boxes, tuning).cut_axis, -1);
}

// However little moving and sweeping cost: copies take memory.
BOOST_AUTO_TEST_CASE(cuts_make_at_most_one_copy_of_two_boxes)
{
  Box_tuning tuning;
  tuning.move_cost = tuning.box_cost = tuning.piece_cost = 0;
  for(const double length : {0.01, 0.02, 0.04}) {
    const double pieces = plan_of<2>(uniform_boxes(10000, {length, length}), tuning).piece_count;
    BOOST_CHECK_LT(pieces * length, 0.55);
    BOOST_CHECK_GT(pieces * length, 0.2);
  }
}

BOOST_AUTO_TEST_CASE(long_boxes_are_long_in_the_range_of_the_boxes)
{
  const Number_boxes boxes = uniform_boxes(5000, {0.1, 0.3});
  const Number_objects objects(boxes, 2);
  with_piece<2>(objects, std::nullopt, [&](const auto&, const auto& piece) {
    for(const double length : internal::Box_planner<2>().plan(piece, 16384).long_lengths)
      BOOST_CHECK_CLOSE(length, internal::long_share, 1);
  });
}

BOOST_AUTO_TEST_SUITE_END()
