// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hashes of cells, and the sizes of hash tables.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>

BOOST_AUTO_TEST_SUITE(hash)

using namespace test_support;

BOOST_AUTO_TEST_CASE(tables_are_powers_of_two_and_at_most_half_full)
{
  for(std::size_t size = 0; size < 5000; ++size) {
    const std::size_t slots = std::size_t(1) << internal::hash_table_bits(size);
    BOOST_CHECK_GE(slots, 2 * size);
    BOOST_CHECK_GE(slots, 16u);
    BOOST_CHECK(slots == 16 || slots < 4 * size); // and no larger than that
  }
}

std::uint64_t hash_of(std::uint64_t a, std::uint64_t b, std::uint64_t seed)
{
  const internal::Sequence_hash<2> hash(2, seed);
  return hash.finish(hash.add(hash.add(0, 0, a), 1, b));
}

// Multiples of powers of two around the origin, such as cells and coordinates are: no two have the
// same hash, and the upper 15 bits, and those below them, fill a table about as well as random
// numbers do, which leave 24155 of 32768 slots free.
BOOST_AUTO_TEST_CASE(sequences_have_hashes_of_their_own_at_any_scale)
{
  for(const int exponent : {0, 20, 31, 32, 40, 52, 57})
    for(const std::uint64_t seed : {1, 2, 3}) {
      std::set<std::uint64_t> hashes, first_slots, last_slots;
      for(std::int64_t x = -50; x < 50; ++x)
        for(std::int64_t y = -50; y < 50; ++y) {
          const std::uint64_t hash = hash_of(std::uint64_t(x) << exponent,
                                             std::uint64_t(y) << exponent, seed);
          hashes.insert(hash);
          first_slots.insert(hash >> 49);
          last_slots.insert((hash >> 34) % 32768);
        }
      BOOST_CHECK_GE(hashes.size(), 9999u);
      BOOST_CHECK_GT(first_slots.size(), 8000u);
      BOOST_CHECK_GT(last_slots.size(), 8000u);
    }
}

// Of pairs of sequences with one hash for one seed, hardly any have one hash for another seed.
BOOST_AUTO_TEST_CASE(another_seed_has_other_collisions)
{
  std::size_t first = 0, both = 0;
  for(std::uint64_t a = 0; a < 400000; ++a)
    if(hash_of(a, 1, 1) >> 54 == hash_of(1, a, 1) >> 54) {
      ++first;
      both += hash_of(a, 1, 2) >> 54 == hash_of(1, a, 2) >> 54;
    }
  BOOST_CHECK_GT(first, 300u);
  BOOST_CHECK_LT(both, 5u);
}

BOOST_AUTO_TEST_CASE(a_process_has_one_seed)
{
  BOOST_CHECK_EQUAL(internal::seed_of_process(), internal::seed_of_process());
}

BOOST_AUTO_TEST_CASE(the_length_of_sequences_may_be_known_at_run_time_only)
{
  const internal::Sequence_hash<2> hash(2, 7);
  const internal::Sequence_hash<> other(2, 7);
  BOOST_CHECK_EQUAL(hash.finish(hash.add(hash.add(0, 0, 5), 1, 6)),
                    other.finish(other.add(other.add(0, 0, 5), 1, 6)));
}

BOOST_AUTO_TEST_SUITE_END()
