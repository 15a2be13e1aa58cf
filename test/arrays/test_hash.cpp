// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hashes of cells, and the sizes of hash tables.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <cstdint>
#include <set>

BOOST_AUTO_TEST_SUITE(hash)

namespace internal = CGAL::Thick_intersection_d::internal;

BOOST_AUTO_TEST_CASE(tables_are_powers_of_two_and_at_most_half_full)
{
  for(std::size_t size = 0; size < 5000; ++size) {
    const std::size_t slots = internal::hash_table_size(size);
    BOOST_CHECK_EQUAL(slots & (slots - 1), 0u);
    BOOST_CHECK_GE(slots, 2 * size);
    BOOST_CHECK_GE(slots, 16u);
    BOOST_CHECK(slots == 16 || slots < 4 * size); // and no larger than that
  }
}

// The cells around the origin: no two have the same hash, and the last 15 bits fill a table about
// as well as random numbers do, which leave 24155 of 32768 slots free.
BOOST_AUTO_TEST_CASE(cells_have_hashes_of_their_own)
{
  std::set<std::uint64_t> hashes, slots;
  for(std::int64_t x = -50; x < 50; ++x)
    for(std::int64_t y = -50; y < 50; ++y) {
      const std::uint64_t hash
        = internal::finish_hash(internal::add_to_hash(internal::add_to_hash(0, x), y));
      hashes.insert(hash);
      slots.insert(hash % 32768);
    }
  BOOST_CHECK_EQUAL(hashes.size(), 10000u);
  BOOST_CHECK_GT(slots.size(), 8000u);
}

BOOST_AUTO_TEST_CASE(a_hash_depends_on_the_order)
{
  const auto hash = [](std::uint64_t a, std::uint64_t b) {
    return internal::finish_hash(internal::add_to_hash(internal::add_to_hash(0, a), b));
  };
  BOOST_CHECK_NE(hash(1, 2), hash(2, 1));
  BOOST_CHECK_NE(hash(1, 0), hash(0, 1));
}

BOOST_AUTO_TEST_SUITE_END()
