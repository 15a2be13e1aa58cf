// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Distinct numbers, few and many, against the sort of the standard library.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/sort_distinct.h>

BOOST_AUTO_TEST_SUITE(sort_distinct)

using namespace test_support;

// Sorts in memory that is kept, and holds what was sorted before.
class Sorter
{
public:
  void operator()(std::vector<std::uint32_t>& numbers)
  {
    internal::sort_distinct(numbers.data(), numbers.data() + numbers.size(), memory_);
  }

private:
  internal::Buffer<std::uint32_t> memory_;
};

// The same numbers come in any order, with the least and the largest one.
BOOST_AUTO_TEST_CASE(any_order_is_sorted)
{
  Random random(6);
  Sorter sort;
  for(std::size_t size = 2; size < 600; ++size) {
    std::vector<std::uint32_t> expected = {0, 0xffffffffu};
    for(std::size_t i = 2; i < size; ++i)
      expected.push_back(static_cast<std::uint32_t>(i * 7158278));
    std::vector<std::uint32_t> numbers = shuffled(expected, random);
    std::sort(expected.begin(), expected.end());
    sort(numbers);
    BOOST_CHECK(numbers == expected);
  }
}

BOOST_AUTO_TEST_SUITE_END()
