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
#include <CGAL/Thick_intersection_d/internal/machine/Stop_flag.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>

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
template <class Objects>
Pairs by_sweeps(const Objects& objects, std::optional<std::size_t> first_set_size,
                internal::Place block_count)
{
  Pairs pairs;
  const auto callback = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  internal::Unwatched_progress progress;
  with_piece<2>(objects, first_set_size, callback, progress, [&](auto& client, const auto& piece) {
    internal::Box_order<2> order;
    order.set(piece, 0);
    internal::Stop_flag stop;
    internal::Box_sweep<2> sweep(client, stop);
    for(internal::Place block = 0; block < block_count; ++block) {
      sweep.take_block(block, block_count);
      for(std::size_t set = 0; set < piece.set_count(); ++set)
        sweep.between(order.run(set), order.candidates(set));
    }
    BOOST_CHECK(!stop.is_set());
  });
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
      BOOST_CHECK(by_sweeps(Number_objects(boxes, 2), first_set_size, blocks) == all);
      BOOST_CHECK(by_sweeps(Half_of_the_objects(boxes), first_set_size, blocks) == half);
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

// Returns whether a sweep over a set of objects stops.
template <class Objects, class Callback>
bool does_sweep_stop(const Objects& objects, Callback& callback)
{
  internal::Unwatched_progress progress;
  return with_piece<2>(objects, std::nullopt, callback, progress,
                       [](auto& client, const auto& piece) {
                         internal::Box_order<2> order;
                         order.set(piece, 0);
                         internal::Stop_flag stop;
                         internal::Box_sweep<2> sweep(client, stop);
                         sweep.between(order.run(0), order.run(0));
                         return stop.is_set();
                       });
}

BOOST_AUTO_TEST_CASE(a_sweep_stops_when_the_report_says_so)
{
  int calls = 0;
  const auto stop = [&](std::size_t, std::size_t) { return ++calls < 10; };
  const Number_boxes boxes = equal_boxes(200);
  BOOST_CHECK(does_sweep_stop(Number_objects(boxes, 2), stop));
  BOOST_CHECK_EQUAL(std::exchange(calls, 0), 10);
  BOOST_CHECK(does_sweep_stop(Half_of_the_objects(boxes), stop));
  BOOST_CHECK_EQUAL(calls, 10);
}

BOOST_AUTO_TEST_SUITE_END()
