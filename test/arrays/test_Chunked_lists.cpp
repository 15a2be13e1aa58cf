// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Chunked lists against vectors, also when memory runs out.

#include "support/counting_allocator.h"
#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Chunked_lists.h>

BOOST_AUTO_TEST_SUITE(Chunked_lists)

using namespace test_support;

using Lists = internal::Chunked_lists<int, 4>;
using Vectors = std::vector<std::vector<int>>;

Vectors items_of(const Lists& lists, std::size_t list_count)
{
  Vectors items(list_count);
  for(std::size_t list = 0; list < list_count; ++list)
    lists.for_each(list, [&](int item) {
      items[list].push_back(item);
      return true;
    });
  return items;
}

BOOST_AUTO_TEST_CASE(each_list_keeps_its_items_in_order)
{
  Random random(1);
  Lists lists(10);
  Vectors expected(10);
  for(int item = 0; item < 30000; ++item) { // some blocks of the largest size
    const std::size_t list = random.below(9); // one list stays empty
    lists.append(list, item);
    expected[list].push_back(item);
  }
  BOOST_CHECK(items_of(lists, 10) == expected);
  for(std::size_t list = 0; list < 10; ++list)
    BOOST_CHECK_EQUAL(lists.size(list), expected[list].size());
}

BOOST_AUTO_TEST_CASE(a_task_stops_the_loop_by_returning_false)
{
  Lists lists(1);
  for(int item = 0; item < 10; ++item)
    lists.append(0, item);
  for(int last = 0; last < 12; ++last) {
    int calls = 0;
    const bool is_complete = lists.for_each(0, [&](int item) {
      ++calls;
      return item != last;
    });
    BOOST_CHECK_EQUAL(is_complete, last >= 10);
    BOOST_CHECK_EQUAL(calls, last < 10 ? last + 1 : 10);
  }
}

// Appends until memory runs out; returns whether it did.
bool append_until_it_throws(Lists& lists, Vectors& expected, std::size_t allocations, int count)
{
  for(int item = 0; item < count; ++item) {
    const std::size_t list = static_cast<std::size_t>(item) % 3;
    expected[list].push_back(item); // may allocate, so it comes first
    try {
      const Memory_that_runs_out memory(allocations);
      lists.append(list, item);
    }
    catch(const std::bad_alloc&) {
      expected[list].pop_back();
      return true;
    }
  }
  return false;
}

BOOST_AUTO_TEST_CASE(lists_are_as_before_when_memory_runs_out)
{
  int failures = 0;
  for(int before = 0; before < 100; ++before)
    for(const std::size_t allocations : {0, 1, 2}) {
      Lists lists(3);
      Vectors expected(3);
      BOOST_REQUIRE(!append_until_it_throws(lists, expected, 1000, before));
      failures += append_until_it_throws(lists, expected, allocations, 40);
      BOOST_CHECK(items_of(lists, 3) == expected);
      for(std::size_t list = 0; list < 3; ++list)
        BOOST_CHECK_EQUAL(lists.size(list), expected[list].size());
      BOOST_CHECK(!append_until_it_throws(lists, expected, 1000, 40)); // and work again
      BOOST_CHECK(items_of(lists, 3) == expected);
    }
  BOOST_CHECK_GT(failures, 100);
}

BOOST_AUTO_TEST_SUITE_END()
