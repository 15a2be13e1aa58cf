// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_H

// Hashes of sequences of integers, such as the numbers of a cell along the axes.

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the hash of the sequence so far with one more integer. The factor is 2^64 over the golden
// ratio. The upper bits of a product are the best, so they are folded into the lower bits first.
inline std::uint64_t add_to_hash(std::uint64_t hash, std::uint64_t number)
{
  return (hash ^ (hash >> 32) ^ number) * 0x9e3779b97f4a7c15;
}

// Returns the hash of the whole sequence. All bits of the result may be used.
inline std::uint64_t finish_hash(std::uint64_t hash) { return hash ^ (hash >> 32); }

// Returns the number of slots of a hash table for `size` entries. It is a power of two, and the
// table is at most half full.
inline std::size_t hash_table_size(std::size_t size)
{
  std::size_t slot_count = 16;
  while(slot_count < 2 * size)
    slot_count *= 2;
  return slot_count;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_H
