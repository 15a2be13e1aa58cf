// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_TABLE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_TABLE_H

// A hash table of small entries, with open addressing.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A slot that has `Free` is free. The upper bits of a hash give the slot from which on an entry is
// looked for. At most half of the slots may be taken, so that each search ends soon.
template <class Entry, Entry Free>
class Hash_table
{
public:
  // Has room for nothing.
  Hash_table() = default;

  explicit Hash_table(std::size_t most_entries)
    : bits_(hash_table_bits(most_entries)), slots_(std::size_t(1) << bits_, Free)
  {}

  std::size_t slot_count() const { return slots_.size(); }

  Entry& operator[](std::size_t slot) { return slots_[slot]; }
  Entry operator[](std::size_t slot) const { return slots_[slot]; }

  // Returns the slot of the entry with a hash for which is_it(entry), or the free one where it
  // belongs.
  template <class Is_it>
  std::size_t find(std::uint64_t hash, const Is_it& is_it) const
  {
    std::size_t slot = static_cast<std::size_t>(hash >> (64 - bits_));
    while(slots_[slot] != Free && !is_it(slots_[slot]))
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

private:
  int bits_ = 0; // of a slot
  std::vector<Entry> slots_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_HASH_TABLE_H
