// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Buckets of cells, offsets to adjacent cells, and strips. That adjacent cells are found is left to
// test_Close_pair_buckets.cpp.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_table.h>

BOOST_AUTO_TEST_SUITE(Cell_table)

using namespace test_support;

BOOST_AUTO_TEST_CASE(each_cell_has_a_bucket)
{
  Random random(1);
  for(const std::size_t side : {1, 3, 10, 1000}) {
    std::vector<std::array<internal::Cell_number, 3>> cells(700);
    for(auto& cell : cells)
      for(internal::Cell_number& number : cell)
        number = 0xfffffffe - static_cast<internal::Cell_number>(random.below(side));
    const internal::Cell_table table(cells.size(), 3, [&](std::size_t member, int axis) {
      return cells[member][static_cast<std::size_t>(axis)];
    });
    BOOST_CHECK_EQUAL(table.bucket_count(), std::set(cells.begin(), cells.end()).size());
    for(std::size_t bucket = 0; bucket < table.bucket_count(); ++bucket)
      for(std::size_t place = table.begin(bucket); place < table.end(bucket); ++place)
        for(std::size_t axis = 0; axis < 3; ++axis)
          BOOST_CHECK_EQUAL(cells[table.member(place)][axis],
                            table.number(bucket, static_cast<int>(axis)));
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

// A strip ends as late as it can: heights 0, 1, ..., 99 are in strips of 4 for distance 3.
BOOST_AUTO_TEST_CASE(strips_are_as_long_as_the_distance)
{
  const auto is_beyond = [](int b, int a) { return b - a > 3; };
  internal::Strip_numbering<int, decltype(is_beyond)> number_of_strip(is_beyond);
  for(int height = 0; height < 100; ++height)
    BOOST_CHECK_EQUAL(number_of_strip(height), static_cast<internal::Cell_number>(height / 4 + 1));
}

BOOST_AUTO_TEST_SUITE_END()
