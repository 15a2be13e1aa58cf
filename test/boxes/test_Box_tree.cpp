// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The tree against all pairs, in one to five dimensions, with many equal ends; and how much it
// looks at.

#include "support/number_boxes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(Box_tree)

using namespace test_support;
using Box = internal::Piece_box<1>;

// Looks at boxes by their positions. Counts how often it looks.
struct Counting_test
{
  const Number_boxes& boxes;
  int axes;
  mutable std::size_t looks = 0;

  int dimension() const { return axes; }
  internal::Interval interval(const Box& box, int axis) const
  {
    ++looks;
    return boxes[box.position][axis];
  }
  bool do_meet(const Box& a, const Box& b, int axis_count) const
  {
    ++looks;
    return test_support::do_meet(boxes[a.position], boxes[b.position], axis_count);
  }
};

// Searches one set, or two sets, until there are `limit` pairs.
Pairs pairs_by_tree(const Counting_test& test, std::optional<std::size_t> first_set_size,
                    std::size_t limit = std::size_t(-1))
{
  std::vector<Box> boxes;
  for(internal::Place i = 0; i < test.boxes.size(); ++i)
    boxes.push_back({{0}, {0}, i, 0});
  std::vector<const Box*> a, b;
  for(const Box& box : boxes)
    (box.position < first_set_size.value_or(boxes.size()) ? a : b).push_back(&box);
  Pairs pairs;
  const auto report = [&](const Box& p, const Box& q) {
    pairs.push_back(std::minmax<std::size_t>(p.position, q.position));
    return pairs.size() < limit;
  };
  internal::Box_tree<Box, Counting_test, decltype(report)> tree(test, report);
  const bool goes_on = first_set_size ? tree.between(a, b) : tree.within(a);
  BOOST_CHECK_EQUAL(goes_on, pairs.size() < limit);
  return pairs;
}

// Boxes that are mostly long, so that many of them hold the lower ends of a part.
Number_boxes long_boxes(Generator& random, int dimension, std::size_t size, std::uint64_t side)
{
  Number_boxes boxes(size);
  for(Number_box& box : boxes)
    for(int axis = 0; axis < dimension; ++axis) {
      const double a = below(random, side), b = below(random, side);
      box[axis] = random() % 3 == 0 ? internal::Interval{a, a}
                                    : internal::Interval{(std::min)(a, b), (std::max)(a, b)};
    }
  return boxes;
}

void check_tree(const Number_boxes& boxes, int dimension,
                std::optional<std::size_t> first_set_size, const std::string& name)
{
  const Pairs expected = all_meeting_pairs(boxes, dimension, first_set_size);
  const Pairs found = sorted(pairs_by_tree({boxes, dimension}, first_set_size));
  BOOST_REQUIRE_MESSAGE(found == expected, name << ": " << compare(expected, found));
}

BOOST_AUTO_TEST_CASE(tree_finds_the_pairs_of_structured_boxes)
{
  for(int dimension = 1; dimension <= 5; ++dimension)
    for(unsigned int seed = 0; seed < 2000; ++seed) {
      Generator random(seed);
      const std::size_t size = random() % 60;
      const Number_boxes boxes = structured_boxes(random, dimension, size);
      const std::string name = std::to_string(dimension) + "D, seed " + std::to_string(seed);
      check_tree(boxes, dimension, std::nullopt, name);
      check_tree(boxes, dimension, random() % (size + 1), name + ", two sets");
    }
}

BOOST_AUTO_TEST_CASE(tree_finds_the_pairs_of_long_boxes)
{
  for(int dimension = 1; dimension <= 5; ++dimension)
    for(const std::uint64_t side : {3, 20, 1000000})
      for(unsigned int seed = 0; seed < 20; ++seed) {
        Generator random(seed);
        const std::size_t size = 100 + random() % 300;
        const Number_boxes boxes = long_boxes(random, dimension, size, side);
        const std::string name = std::to_string(dimension) + "D, side " + std::to_string(side)
                                 + ", seed " + std::to_string(seed);
        check_tree(boxes, dimension, std::nullopt, name);
        check_tree(boxes, dimension, random() % size, name + ", two sets");
      }
}

BOOST_AUTO_TEST_CASE(identical_boxes_are_all_pairs)
{
  Number_boxes boxes(300);
  for(Number_box& box : boxes)
    box.fill({1, 1});
  for(int dimension = 1; dimension <= 5; ++dimension) {
    check_tree(boxes, dimension, std::nullopt, "identical");
    check_tree(boxes, dimension, 100, "identical, two sets");
  }
}

BOOST_AUTO_TEST_CASE(tree_stops_when_told)
{
  Generator random(1);
  const Number_boxes boxes = long_boxes(random, 3, 300, 1000);
  const std::size_t all = pairs_by_tree({boxes, 3}, std::nullopt).size();
  for(std::size_t limit = 1; limit <= all; limit += all / 50)
    BOOST_CHECK_EQUAL(pairs_by_tree({boxes, 3}, std::nullopt, limit).size(), limit);
  const std::size_t all_between = pairs_by_tree({boxes, 3}, 150).size();
  for(std::size_t limit = 1; limit <= all_between; limit += all_between / 50)
    BOOST_CHECK_EQUAL(pairs_by_tree({boxes, 3}, 150, limit).size(), limit);
}

// Looks per n log2^d n + k. Half beams: long horizontal boxes, and long vertical ones that are out
// of their way, so that many pairs meet along each axis, but no pair along both.
BOOST_AUTO_TEST_CASE(tree_looks_at_few_boxes)
{
  for(const std::size_t n : {2000, 16000}) {
    Generator random(n);
    Number_boxes beams(n);
    for(std::size_t i = 0; i < n; ++i) {
      const double x = below(random, 1 << 20), y = below(random, 1 << 20);
      const double long_side = 1 << 20;
      if(i % 2)
        beams[i] = {{{0 + x / 8, long_side}, {y, y}}};
      else
        beams[i] = {{{-1 - x, -1 - x}, {0 + y / 8, long_side}}};
    }
    const double size = static_cast<double>(n);
    for(int dimension = 2; dimension <= 3; ++dimension)
      for(const Number_boxes& boxes : {beams, long_boxes(random, dimension, n, 1 << 30)}) {
        const Counting_test test = {boxes, dimension};
        const double k = static_cast<double>(pairs_by_tree(test, std::nullopt).size());
        const double work = static_cast<double>(test.looks)
                            / (size * std::pow(std::log2(size), dimension) + k);
        BOOST_TEST_MESSAGE(dimension << "D, n = " << n << ", k = " << k << ": " << work);
        BOOST_CHECK_LT(work, 3);
      }
  }
}

BOOST_AUTO_TEST_SUITE_END()
