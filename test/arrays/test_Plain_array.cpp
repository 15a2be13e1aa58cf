// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Arrays that hold a vector, or memory of their own.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Plain_array.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(Plain_array)

using Array = CGAL::Thick_intersection_d::internal::Plain_array<int>;
using Vector = std::vector<int>;

Array array_of(int size)
{
  Array array;
  int* const numbers = array.require(static_cast<std::size_t>(size));
  std::iota(numbers, numbers + size, 0);
  return array;
}

BOOST_AUTO_TEST_CASE(arrays_are_ranges)
{
  const Array array = array_of(5);
  BOOST_CHECK((Vector(array.begin(), array.end()) == Vector{0, 1, 2, 3, 4}));
  BOOST_CHECK_EQUAL(array.size(), 5u);
  BOOST_CHECK_EQUAL(array.front(), 0);
  BOOST_CHECK_EQUAL(array.back(), 4);
  BOOST_CHECK_EQUAL(array[3], 3);
  BOOST_CHECK(array.data() == array.begin());
  BOOST_CHECK(!array.empty());
  BOOST_CHECK(Array().empty());
  BOOST_CHECK(array == Array(Vector{0, 1, 2, 3, 4}));
  BOOST_CHECK(array != Array(Vector{0, 1, 2, 3}));
}

BOOST_AUTO_TEST_CASE(memory_is_kept_while_it_suffices)
{
  for(Array array : {array_of(5), Array(Vector{0, 1, 2, 3, 4})}) {
    const int* const before = array.data();
    BOOST_CHECK(array.require(3) == before);
    BOOST_CHECK_EQUAL(array.size(), 3u);
    BOOST_CHECK(array.require(5) == before);
    int* const numbers = array.require(1000);
    std::iota(numbers, numbers + 1000, 0);
    BOOST_CHECK_EQUAL(std::accumulate(array.begin(), array.end(), 0), 499500);
  }
}

BOOST_AUTO_TEST_CASE(copies_have_memory_of_their_own)
{
  Array array = array_of(3), copy = array, assigned;
  assigned = array;
  array.require(3)[0] = 7;
  BOOST_CHECK((copy == Array(Vector{0, 1, 2})));
  BOOST_CHECK((assigned == Array(Vector{0, 1, 2})));
}

BOOST_AUTO_TEST_CASE(vectors_are_moved_in_and_out)
{
  Vector numbers = {4, 5, 6};
  const int* const memory = numbers.data();
  Array array = std::move(numbers);
  BOOST_CHECK(array.data() == memory);
  const Vector copy = array;
  BOOST_CHECK((copy == Vector{4, 5, 6}));
  array.require(2);
  Array moved = std::move(array);
  BOOST_CHECK(moved.data() == memory);
  const Vector out = std::move(moved);
  BOOST_CHECK(out.data() == memory);
  BOOST_CHECK((out == Vector{4, 5}));
  const Vector of_own_memory = array_of(2);
  BOOST_CHECK((of_own_memory == Vector{0, 1}));
}

BOOST_AUTO_TEST_CASE(arrays_that_were_moved_from_are_empty)
{
  for(Array array : {array_of(5), Array(Vector{0, 1, 2, 3, 4})}) {
    Array moved = std::move(array), assigned;
    const auto overwrite = [](Array& moved_from) {
      BOOST_CHECK(moved_from.empty());
      std::fill_n(moved_from.require(3), 3, 7);
    };
    overwrite(array);
    assigned = std::move(moved);
    overwrite(moved);
    BOOST_CHECK((assigned == Array(Vector{0, 1, 2, 3, 4})));
    const Vector out = std::move(assigned);
    overwrite(assigned);
    BOOST_CHECK((out == Vector{0, 1, 2, 3, 4}));
  }
}

BOOST_AUTO_TEST_SUITE_END()
