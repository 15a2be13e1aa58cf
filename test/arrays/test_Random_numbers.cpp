// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Random numbers, against the standard library.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>

BOOST_AUTO_TEST_SUITE(Random_numbers)

using namespace test_support;

BOOST_AUTO_TEST_CASE(numbers_are_those_of_minstd_rand)
{
  BOOST_CHECK_EQUAL(internal::Random_numbers::largest(), (std::minstd_rand::max)());
  for(const std::uint32_t seed : {0u, 1u, 2u, 12345u, 2147483646u, 2147483647u, 4294967295u}) {
    internal::Random_numbers numbers(seed);
    std::minstd_rand expected(seed);
    for(int i = 0; i < 1000; ++i)
      BOOST_REQUIRE_EQUAL(numbers(), expected());
  }
  BOOST_CHECK_EQUAL(internal::Random_numbers()(), std::minstd_rand()());
}

BOOST_AUTO_TEST_CASE(numbers_below_a_limit_are_about_equally_likely)
{
  internal::Random_numbers random;
  for(const std::size_t limit : {1, 2, 3, 7}) {
    std::vector<int> counts(limit);
    for(int i = 0; i < 7000; ++i)
      ++counts.at(random.below(limit));
    for(const int count : counts)
      BOOST_CHECK_CLOSE(static_cast<double>(count), 7000. / static_cast<double>(limit), 15);
  }
}

BOOST_AUTO_TEST_SUITE_END()
