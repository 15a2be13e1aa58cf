// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A box goes to each piece that it meets, and two boxes that meet are in one piece together without
// being copies along a common axis: after cuts within cuts along the same axis, too.

#include "support/number_boxes.h"

#include <boost/test/unit_test.hpp>

#include <map>

BOOST_AUTO_TEST_SUITE(Cut_boxes)

using namespace test_support;
using Box = internal::Piece_box<2>;
using Boxes = std::vector<Box>;
using Piece = internal::Piece<Box>;
using Cut = internal::Cut_boxes<Box>;

Boxes some_boxes(Generator& random)
{
  Boxes boxes;
  const Number_boxes numbers = structured_boxes(random, 2, 1 + random() % 30);
  for(const Number_box& box : numbers)
    boxes.push_back({{box[0].low, box[1].low}, {box[0].high, box[1].high},
                     static_cast<internal::Place>(boxes.size()), 0});
  return boxes;
}

// Into pieces of an interval that need not hold all boxes.
internal::Equal_cut some_cut(const Boxes& boxes, int axis, Generator& random)
{
  internal::Interval range;
  range.add(boxes[random() % boxes.size()].low[axis]);
  range.add(boxes[random() % boxes.size()].high[axis]);
  return internal::Equal_cut(range, 1 + below(random, 9));
}

BOOST_AUTO_TEST_CASE(boxes_go_to_the_pieces_that_they_meet)
{
  for(unsigned int seed = 0; seed < 1000; ++seed) {
    Generator random(seed);
    Boxes boxes = some_boxes(random);
    for(Box& box : boxes)
      box.sides = random() % 4;
    const int axis = seed % 2;
    const internal::Equal_cut equal_cut = some_cut(boxes, axis, random);
    const Piece piece({boxes.data(), boxes.data() + boxes.size()});
    Cut cut(piece, axis, equal_cut, internal::Threads());
    const std::uint64_t size = cut.size();
    cut.distribute();
    std::uint64_t sum = 0;
    for(internal::Place p = 0; p < equal_cut.count(); ++p) {
      const Box* found = cut.piece(p)[0].first;
      for(const Box& box : boxes)
        if(equal_cut(box.low[axis]) <= p && p <= equal_cut(box.high[axis])) {
          BOOST_REQUIRE(found != cut.piece(p)[0].last);
          BOOST_CHECK_EQUAL(found->position, box.position); // in the same order
          BOOST_CHECK(found->low == box.low && found->high == box.high);
          const bool is_copy = equal_cut(box.low[axis]) < p;
          BOOST_CHECK_EQUAL(found->sides, box.sides | (is_copy ? 1u << axis : 0u));
          ++found;
        }
      BOOST_CHECK(found == cut.piece(p)[0].last);
      sum += cut.piece(p).size();
    }
    BOOST_CHECK_EQUAL(sum, size);
  }
}

// Counts for each pair the pieces that hold both boxes, if these are no copies along a common axis.
void count_common_pieces(const internal::Span<Box>& boxes, int depth, Generator& random,
                         std::map<Pair, int>& counts)
{
  if(depth == 0 || boxes.size() == 0) {
    for(const Box* a = boxes.first; a != boxes.last; ++a)
      for(const Box* b = boxes.first; b != a; ++b)
        if((a->sides & b->sides) == 0)
          ++counts[std::minmax<std::size_t>(a->position, b->position)];
    return;
  }
  const int axis = random() % 4 == 0;
  const internal::Equal_cut equal_cut = some_cut(Boxes(boxes.first, boxes.last), axis, random);
  Cut cut(Piece(boxes), axis, equal_cut, internal::Threads());
  cut.distribute();
  for(internal::Place p = 0; p < equal_cut.count(); ++p)
    count_common_pieces(cut.piece(p)[0], depth - 1, random, counts);
}

BOOST_AUTO_TEST_CASE(boxes_that_meet_have_one_common_piece_in_cuts_within_cuts)
{
  for(unsigned int seed = 0; seed < 3000; ++seed) {
    Generator random(seed);
    Boxes boxes = some_boxes(random);
    std::map<Pair, int> counts;
    count_common_pieces({boxes.data(), boxes.data() + boxes.size()}, 1 + seed % 4, random, counts);
    for(std::size_t i = 0; i < boxes.size(); ++i)
      for(std::size_t j = i + 1; j < boxes.size(); ++j) {
        bool meet = true;
        for(int axis = 0; axis < 2; ++axis)
          meet = meet
                 && intervals_meet({boxes[i].low[axis], boxes[i].high[axis]},
                                   {boxes[j].low[axis], boxes[j].high[axis]});
        const int count = counts[Pair(i, j)];
        BOOST_REQUIRE_MESSAGE(count <= 1 && (!meet || count == 1),
                              "seed " << seed << ": " << i << " and " << j << ", " << count);
      }
  }
}

// Each box without sides is in one piece without sides.
BOOST_AUTO_TEST_CASE(every_box_is_itself_in_one_piece)
{
  Generator random(5);
  Boxes boxes = some_boxes(random);
  const internal::Equal_cut equal_cut({-3, 3}, 7);
  Cut cut(Piece({boxes.data(), boxes.data() + boxes.size()}), 0, equal_cut, internal::Threads());
  cut.distribute();
  std::vector<int> seen(boxes.size(), 0);
  for(internal::Place p = 0; p < equal_cut.count(); ++p)
    for(const Box* box = cut.piece(p)[0].first; box != cut.piece(p)[0].last; ++box)
      seen[box->position] += box->sides == 0;
  BOOST_CHECK(seen == std::vector<int>(boxes.size(), 1));
}

BOOST_AUTO_TEST_SUITE_END()
