// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_KNOWN_PAIRS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_KNOWN_PAIRS_H

// The pairs that are found already, in hash tables: several threads ask and add at once.

#include <CGAL/Thick_intersection_d/internal/arrays/Hash_table.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A set of numbers that are not zero.
class Hashed_numbers
{
public:
  Hashed_numbers() : hash_(1, seed_of_process()) {}

  bool has(std::uint64_t number) const
  {
    return size_ != 0 && table_[slot_of(number)] == number;
  }

  // Returns false if the set has the number already.
  bool add(std::uint64_t number)
  {
    if(table_.slot_count() < 2 * (size_ + 1))
      grow();
    std::uint64_t& slot = table_[slot_of(number)];
    if(slot == number)
      return false;
    slot = number;
    ++size_;
    return true;
  }

private:
  using Table = Hash_table<std::uint64_t, 0>;

  std::size_t slot_of(std::uint64_t number) const
  {
    return table_.find(hash_.finish(hash_.add(0, 0, number)),
                       [=](std::uint64_t other) { return other == number; });
  }

  void grow()
  {
    const Table old = std::exchange(table_, Table(size_ + 1));
    for(std::size_t slot = 0; slot < old.slot_count(); ++slot)
      if(old[slot] != 0)
        table_[slot_of(old[slot])] = old[slot];
  }

  const Sequence_hash<1> hash_;
  Table table_;
  std::size_t size_ = 0;
};

// A thread that asks locks one of several sets for a moment.
class Known_pairs
{
public:
  explicit Known_pairs(const Threads& threads)
    : are_threads_many_(threads.are_many()), sets_(threads.are_many() ? set_count : 1)
  {}

  bool has(Place i, Place j) const
  {
    return in_set(i, j, [](const Hashed_numbers& numbers, std::uint64_t number) {
      return numbers.has(number);
    });
  }

  // Adds a pair of different positions. Returns false if it is known already.
  bool add(Place i, Place j)
  {
    return in_set(i, j, [](Hashed_numbers& numbers, std::uint64_t number) {
      return numbers.add(number);
    });
  }

private:
  static constexpr std::size_t set_count = 256; // for many threads

  struct Set
  {
    std::mutex mutex;
    Hashed_numbers numbers;
  };

  // The larger position is not zero, so the number of a pair is not.
  template <class Function>
  bool in_set(Place i, Place j, const Function& function) const
  {
    const std::uint64_t number = std::uint64_t((std::max)(i, j)) << 32 | (std::min)(i, j);
    Set& set = are_threads_many_ ? sets_[(std::size_t(i) + j) % set_count] : sets_.front();
    std::unique_lock<std::mutex> lock(set.mutex, std::defer_lock);
    if(are_threads_many_)
      lock.lock();
    return function(set.numbers, number);
  }

  const bool are_threads_many_;
  mutable std::vector<Set> sets_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_KNOWN_PAIRS_H
