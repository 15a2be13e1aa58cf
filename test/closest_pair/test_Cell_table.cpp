// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Strips. Buckets, and the way to those of adjacent cells, against a map of the standard library.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>

BOOST_AUTO_TEST_SUITE(Cell_table)

using namespace test_support;

using Cell = std::vector<internal::Cell_number>;
using Members = std::vector<std::uint32_t>;

// The cell of each member: numbers that begin at 1, or end at 2^32 - 2.
std::vector<Cell> random_cells(int axis_count, std::size_t size, std::size_t side)
{
  Random random(size);
  std::vector<Cell> cells;
  for(std::size_t i = 0; i < size; ++i) {
    cells.emplace_back();
    for(int axis = 0; axis < axis_count; ++axis) {
      const auto number = static_cast<internal::Cell_number>(random.below(side));
      cells.back().push_back(axis == 1 ? 0xfffffffe - number : number + 1);
    }
  }
  return cells;
}

internal::Cell_table table_of(const std::vector<Cell>& cells, int axis_count)
{
  return internal::Cell_table(cells.size(), axis_count, [&](std::size_t member, int axis) {
    return cells[member][static_cast<std::size_t>(axis)];
  });
}

std::map<Cell, Members> map_of(const std::vector<Cell>& cells)
{
  std::map<Cell, Members> map;
  for(std::size_t i = 0; i < cells.size(); ++i)
    map[cells[i]].push_back(static_cast<std::uint32_t>(i));
  return map;
}

// The buckets are in lexicographic order, and their members in order.
void check_buckets(const internal::Cell_table& table, const std::map<Cell, Members>& map)
{
  BOOST_REQUIRE_EQUAL(table.bucket_count(), map.size());
  std::size_t bucket = 0;
  for(const auto& [cell, members] : map) {
    for(std::size_t axis = 0; axis < cell.size(); ++axis)
      BOOST_CHECK_EQUAL(table.number(bucket, static_cast<int>(axis)), cell[axis]);
    BOOST_REQUIRE_EQUAL(table.end(bucket) - table.begin(bucket), members.size());
    for(std::size_t i = 0; i < members.size(); ++i)
      BOOST_CHECK_EQUAL(table.member(table.begin(bucket) + i), members[i]);
    ++bucket;
  }
}

// Asks for all offsets of all buckets, in order.
void check_finder(const internal::Cell_table& table, const internal::Forward_offsets& offsets,
                  const std::map<Cell, Members>& map)
{
  internal::Sorted_bucket_finder find(table, offsets, 0);
  std::size_t bucket = 0;
  for(const auto& each : map) {
    for(std::size_t i = 0; i < offsets.size(); ++i) {
      Cell cell = each.first;
      for(std::size_t axis = 0; axis < cell.size(); ++axis)
        cell[axis] += static_cast<internal::Cell_number>(offsets[i][axis]);
      const auto expected = static_cast<std::size_t>(std::distance(map.begin(), map.find(cell)));
      BOOST_CHECK_EQUAL(find(bucket, i), expected); // the number of buckets if there is none
    }
    ++bucket;
  }
}

BOOST_AUTO_TEST_CASE(buckets_are_those_of_a_map)
{
  for(const int axis_count : {1, 2, 3, 4})
    for(const std::size_t size : {1, 2, 30, 300, 700})
      for(const std::size_t side : {1, 3, 10, 1000}) {
        const std::vector<Cell> cells = random_cells(axis_count, size, side);
        const std::map<Cell, Members> map = map_of(cells);
        const internal::Cell_table table = table_of(cells, axis_count);
        check_buckets(table, map);
        const internal::Forward_offsets offsets(axis_count);
        check_finder(table, offsets, map);
      }
}

// Of each offset and the opposite one, one is forward.
BOOST_AUTO_TEST_CASE(half_of_the_offsets_are_forward)
{
  for(const int axis_count : {1, 2, 3, 5}) {
    const internal::Forward_offsets offsets(axis_count);
    const auto all = static_cast<std::size_t>(std::lround(std::pow(3, axis_count)));
    BOOST_CHECK_EQUAL(2 * offsets.size() + 1, all);
    std::map<std::vector<int>, int> times;
    for(std::size_t i = 0; i < offsets.size(); ++i) {
      std::vector<int> offset = offsets[i];
      ++times[offset];
      for(int& along_axis : offset) {
        BOOST_CHECK(-1 <= along_axis && along_axis <= 1);
        along_axis = -along_axis;
      }
      ++times[offset];
    }
    BOOST_CHECK_EQUAL(times.size(), all - 1);
    for(const auto& each : times)
      BOOST_CHECK_EQUAL(each.second, 1);
  }
}

// In order, with many equal ones.
std::vector<int> random_heights(std::size_t size, std::size_t side, Random& random)
{
  std::vector<int> heights;
  for(std::size_t i = 0; i < size; ++i)
    heights.push_back(static_cast<int>(random.below(side)));
  std::sort(heights.begin(), heights.end());
  return heights;
}

void check_strips(const std::vector<int>& heights, int distance)
{
  const auto is_beyond = [&](int b, int a) { return b - a > distance; };
  internal::Strip_numbering<int, decltype(is_beyond)> number_of_strip(is_beyond);
  std::vector<internal::Cell_number> numbers;
  for(const int height : heights)
    numbers.push_back(number_of_strip(height));
  for(std::size_t i = 0; i < heights.size(); ++i)
    for(std::size_t j = i; j < heights.size(); ++j) {
      if(heights[j] - heights[i] <= distance)
        BOOST_CHECK_LE(numbers[j] - numbers[i], 1u);
      if(numbers[i] == numbers[j])
        BOOST_CHECK_LE(heights[j] - heights[i], distance);
      else
        BOOST_CHECK_LT(numbers[i], numbers[j]);
    }
  BOOST_CHECK(numbers.empty() || numbers.front() == 1);
}

BOOST_AUTO_TEST_CASE(near_elements_are_in_adjacent_strips)
{
  Random random(1);
  for(const std::size_t size : {0, 1, 2, 10, 60})
    for(const std::size_t side : {1, 5, 50, 1000})
      for(const int distance : {0, 1, 3, 20})
        check_strips(random_heights(size, side, random), distance);
}

// A strip ends as late as it can: heights 0, 1, ..., 99 are in strips of 4 for distance 3.
BOOST_AUTO_TEST_CASE(strips_are_as_long_as_the_distance)
{
  const auto is_beyond = [](int b, int a) { return b - a > 3; };
  internal::Strip_numbering<int, decltype(is_beyond)> number_of_strip(is_beyond);
  for(int height = 0; height < 100; ++height)
    BOOST_CHECK_EQUAL(number_of_strip(height), static_cast<internal::Cell_number>(height / 4 + 1));
}

BOOST_AUTO_TEST_SUITE_END()
