// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Strips that are found by comparisons: near elements are in one strip or in adjacent ones.

#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/closest_pair/Strip_numbering.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(Strip_numbering)

using namespace test_support;
namespace internal = CGAL::Thick_intersection_d::internal;

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
