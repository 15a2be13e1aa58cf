// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The radix sort against a stable sort of the standard library, and the keys of all kinds of
// doubles against their order.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>

BOOST_AUTO_TEST_SUITE(radix_sort)

using namespace test_support;

// Zeros of both signs, denormal, normal and infinite numbers, and some of every magnitude.
std::vector<double> all_kinds_of_doubles()
{
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers = {0, Limits::denorm_min(), (Limits::min)() / 2, (Limits::min)(),
                                 1, (Limits::max)(), Limits::infinity()};
  Random random(3);
  for(int exponent = -1074; exponent < 1024; exponent += 9)
    numbers.push_back(std::ldexp(1 + random.uniform(), exponent));
  for(std::size_t i = numbers.size(); i-- > 0;)
    numbers.push_back(-numbers[i]);
  return numbers;
}

BOOST_AUTO_TEST_CASE(keys_are_in_the_order_of_the_numbers)
{
  const std::vector<double> numbers = all_kinds_of_doubles();
  for(const double x : numbers)
    for(const double y : numbers) {
      BOOST_CHECK_EQUAL(internal::radix_key(x) < internal::radix_key(y), x < y);
      BOOST_CHECK_EQUAL(internal::radix_key(x) == internal::radix_key(y), x == y);
    }
}

void check_sort(std::vector<internal::Keyed_value> items)
{
  std::vector<internal::Keyed_value> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const auto& a, const auto& b) { return a.key < b.key; });
  internal::radix_sort(items);
  BOOST_CHECK(std::equal(items.begin(), items.end(), expected.begin(), expected.end(),
                         [](const auto& a, const auto& b) {
                           return a.key == b.key && a.value == b.value;
                         }));
}

// Below 256 items, and above. Keys differ in all digits, or in those of a mask.
BOOST_AUTO_TEST_CASE(values_of_equal_keys_keep_their_order)
{
  Random random(4);
  const std::uint64_t top = std::uint64_t(3) << 62;
  for(const std::size_t size : {0, 1, 2, 100, 255, 256, 257, 3000})
    for(const std::uint64_t mask : {~std::uint64_t(0), std::uint64_t(0), std::uint64_t(7), top,
                                    top | 7, std::uint64_t(0x3ff) << 11}) {
      std::vector<internal::Keyed_value> items;
      for(std::uint32_t value = 0; value < size; ++value)
        items.push_back({(random.below(1u << 31) << 33 | random.below(1u << 31)) & mask, value});
      check_sort(items);
    }
}

BOOST_AUTO_TEST_SUITE_END()
