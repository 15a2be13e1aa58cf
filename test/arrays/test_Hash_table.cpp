// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A hash table finds its entries, whatever their hashes are.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/Hash_table.h>

BOOST_AUTO_TEST_SUITE(Hash_table)

using namespace test_support;

using Table = internal::Hash_table<std::uint64_t, 0>;

std::size_t slot_of(const Table& table, std::uint64_t hash, std::uint64_t number)
{
  return table.find(hash, [&](std::uint64_t other) { return other == number; });
}

BOOST_AUTO_TEST_CASE(entries_with_one_hash_follow_each_other)
{
  for(const std::uint64_t slot : {0, 15}) {
    Table table(8);
    BOOST_REQUIRE_EQUAL(table.slot_count(), 16);
    const std::uint64_t hash = slot << 60;
    for(std::uint64_t number = 1; number <= 8; ++number) {
      BOOST_CHECK_EQUAL(slot_of(table, hash, number), (slot + number - 1) % 16);
      table[slot_of(table, hash, number)] = number;
    }
    for(std::uint64_t number = 1; number <= 8; ++number)
      BOOST_CHECK_EQUAL(table[slot_of(table, hash, number)], number);
    BOOST_CHECK_EQUAL(table[slot_of(table, hash, 9)], 0);
  }
}

BOOST_AUTO_TEST_CASE(entries_with_other_hashes_have_slots_of_their_own)
{
  Table table(100);
  BOOST_REQUIRE_EQUAL(table.slot_count(), 256);
  for(std::uint64_t number = 1; number <= 100; ++number)
    BOOST_CHECK_EQUAL(slot_of(table, number << 56, number), number);
}

BOOST_AUTO_TEST_CASE(any_entry_may_stand_for_a_free_slot)
{
  internal::Hash_table<std::int32_t, -1> table(3);
  const auto is_zero = [](std::int32_t entry) { return entry == 0; };
  BOOST_CHECK_EQUAL(table[table.find(0, is_zero)], -1);
  table[0] = 0;
  BOOST_CHECK_EQUAL(table.find(0, is_zero), 0);
}

BOOST_AUTO_TEST_CASE(a_table_without_room_has_no_slots)
{
  BOOST_CHECK_EQUAL(Table().slot_count(), 0);
}

BOOST_AUTO_TEST_SUITE_END()
