// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Sweeps of boxes report each meeting pair once, the smaller position first; in blocks, each block
// its share.

#include "support/number_boxes.h"
#include "support/pairs.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_order.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_sweep.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxed_objects.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_reporter.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Box_sweep)

using namespace test_support;

// Of those whose boxes meet, each second pair intersects.
class Half_of_the_objects : public Number_objects
{
public:
  explicit Half_of_the_objects(const Number_boxes& boxes) : Number_objects(boxes, 2, false) {}

  bool do_intersect(std::size_t i, std::size_t j) const { return (i + j) % 2 == 0; }
};

// Sweeps all blocks. The blocks have no pair in common.
template <class Test>
Pairs by_sweeps(const Test& test, const internal::Piece<internal::Piece_box<2>>& piece,
                internal::Place block_count)
{
  Pairs pairs;
  auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  internal::Pair_reporter<decltype(callback)> report(callback);
  internal::Box_order<2> order;
  order.set(piece, 0);
  internal::Box_sweep<Test, decltype(report)> sweep(test, report);
  for(internal::Place block = 0; block < block_count; ++block) {
    sweep.take_block(block, block_count);
    for(std::size_t set = 0; set < piece.set_count(); ++set)
      sweep.between(order.run(set), order.candidates(set));
  }
  BOOST_CHECK(!sweep.is_stopped());
  return sorted(pairs);
}

void check_boxes(std::size_t size, unsigned int seed)
{
  Generator random(seed);
  const Number_boxes boxes = structured_boxes(random, 2, size);
  for(const std::optional<std::size_t> first_set_size :
      {std::optional<std::size_t>(), std::optional<std::size_t>(size / 3)}) {
    const Pairs all = all_meeting_pairs(boxes, 2, first_set_size);
    Pairs half;
    for(const Pair& pair : all)
      if((pair.first + pair.second) % 2 == 0)
        half.push_back(pair);
    for(const internal::Place blocks : {1, 2, 3, 7, 64}) {
      const auto check = [&](const Pairs& expected) {
        return [&](const auto& test, const auto& piece) {
          BOOST_CHECK(by_sweeps(test, piece, blocks) == expected);
        };
      };
      with_piece<2>(Number_objects(boxes, 2), first_set_size, check(all));
      with_piece<2>(Half_of_the_objects(boxes), first_set_size, check(half));
    }
  }
}

BOOST_AUTO_TEST_CASE(all_blocks_together_report_each_pair_once)
{
  for(unsigned int size = 1; size <= 60; ++size)
    check_boxes(size, size);
  check_boxes(500, 6); // found pairs by the thousand
}

Number_boxes equal_boxes(std::size_t size)
{
  Number_box unit = {};
  std::fill(unit.begin(), unit.end(), internal::Interval{0, 1});
  return Number_boxes(size, unit);
}

// Calls check(sweep) after one sweep over a set of objects.
template <class Objects, class Callback, class Check>
void sweep_once(const Objects& objects, Callback& callback, const Check& check)
{
  using Test = internal::Boxed_objects<2, Objects>;
  const Test test(objects, {0, 1});
  std::vector<internal::Piece_box<2>> boxes(objects.size());
  for(std::size_t i = 0; i < boxes.size(); ++i)
    test.put(i, boxes[i]);
  internal::Box_order<2> order;
  using Piece = internal::Piece<internal::Piece_box<2>>;
  order.set(Piece({boxes.data(), boxes.data() + boxes.size()}), 0);
  internal::Pair_reporter<Callback> report(callback);
  internal::Box_sweep<Test, decltype(report)> sweep(test, report);
  sweep.between(order.run(0), order.run(0));
  check(sweep);
}

BOOST_AUTO_TEST_CASE(a_sweep_stops_when_the_report_says_so)
{
  int calls = 0;
  const auto stop = [&](std::size_t, std::size_t) { return ++calls < 10; };
  const auto check = [&](const auto& sweep) {
    BOOST_CHECK(sweep.is_stopped());
    BOOST_CHECK_EQUAL(std::exchange(calls, 0), 10);
  };
  const Number_boxes boxes = equal_boxes(200);
  sweep_once(Number_objects(boxes, 2), stop, check);
  sweep_once(Half_of_the_objects(boxes), stop, check);
}

BOOST_AUTO_TEST_SUITE_END()
