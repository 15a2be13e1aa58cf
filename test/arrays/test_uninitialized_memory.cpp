// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A buffer gives room for as much as is asked for, and uses its memory again.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

BOOST_AUTO_TEST_SUITE(uninitialized_memory)

using namespace test_support;
using Buffer = internal::Buffer<int>;

BOOST_AUTO_TEST_CASE(memory_is_used_again)
{
  Buffer buffer;
  int* const memory = buffer.require(1000);
  BOOST_CHECK(buffer.require(1) == memory);
  BOOST_CHECK(buffer.require(1000) == memory);
  BOOST_CHECK(buffer.data() == memory);
}

BOOST_AUTO_TEST_CASE(memory_grows)
{
  Buffer buffer;
  for(const std::size_t size : {0, 1, 2, 64, 65, 100000, 5}) {
    int* const memory = buffer.require(size);
    BOOST_CHECK(memory != nullptr);
    for(std::size_t i = 0; i < size; ++i) // an address sanitizer would notice
      memory[i] = static_cast<int>(i);
    BOOST_CHECK(buffer.data() == memory);
  }
}

BOOST_AUTO_TEST_CASE(a_buffer_that_was_moved_from_can_be_used)
{
  Buffer buffer;
  int* const memory = buffer.require(10);
  const Buffer other = std::move(buffer);
  BOOST_CHECK(other.data() == memory);
  int* const fresh = buffer.require(10);
  BOOST_CHECK(fresh != nullptr && fresh != memory);
}

BOOST_AUTO_TEST_SUITE_END()
