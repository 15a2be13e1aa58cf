// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distinct numbers, few and many, against the sort of the standard library.

#include "support/point_generators.h"

#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

BOOST_AUTO_TEST_SUITE(sort_distinct)

using namespace test_support;

BOOST_AUTO_TEST_CASE(distinct_numbers_are_sorted)
{
  Random random(5);
  for(std::size_t size = 0; size < 300; ++size) {
    std::vector<std::uint32_t> numbers;
    for(std::size_t i = 0; i < size; ++i) // distinct, half of them with the highest bit
      numbers.push_back(static_cast<std::uint32_t>(i << 24 | random.below(1 << 24)) ^ 0xffffffffu);
    std::vector<std::uint32_t> expected = numbers;
    std::sort(expected.begin(), expected.end());
    CGAL::Thick_intersection_d::internal::sort_distinct(numbers.data(), numbers.data() + size);
    BOOST_CHECK(numbers == expected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
