// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_ID_PLACES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_ID_PLACES_H

// The places of points with given ids.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/external/Loaded_points.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Most searches ask for a few places. They are found in the lists of a part: each list has the
// order of the range, so its ids ascend. If a search asks for many, all ids are hashed. Several
// threads may ask at once.
template <int Dimension>
class Id_places
{
public:
  // Finds ids of points that the part owns, which are less than `end`.
  Id_places(const Loaded_points<Dimension>& part, std::uint64_t end) : part_(part), end_(end) {}

  BOOST_NOINLINE std::size_t operator()(std::uint64_t id) const
  {
    if(!is_hashed_.load(std::memory_order_acquire)) {
      if(asked_.fetch_add(1, std::memory_order_relaxed) < part_.owned() / points_per_question)
        return find_in_lists(id);
      hash();
    }
    std::size_t slot = first_slot(id);
    while(part_.columns().ids[slots_[slot]] != id)
      slot = next(slot);
    return slots_[slot];
  }

private:
  // Looking into all lists takes about as long as hashing so many ids.
  static constexpr std::size_t points_per_question = 64;

  std::size_t find_in_lists(std::uint64_t id) const
  {
    const std::uint64_t* const ids = part_.columns().ids;
    const std::uint64_t* last = ids + part_.owned();
    for(std::size_t list = part_.begins().size(); list-- > 0; ) {
      const std::uint64_t* const first = ids + part_.begins()[list];
      const std::uint64_t* const found = std::lower_bound(first, last, id);
      if(found != last && *found == id)
        return static_cast<std::size_t>(found - ids);
      last = first;
    }
    return 0; // there is no such id
  }

  void hash() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(is_hashed_.load(std::memory_order_relaxed))
      return;
    bits_ = hash_table_bits(part_.owned());
    slots_.assign(std::size_t(1) << bits_, max_place);
    for(std::size_t place = 0; place < part_.owned(); ++place)
      if(const std::uint64_t id = part_.columns().ids[place]; id < end_) {
        std::size_t slot = first_slot(id);
        while(slots_[slot] != max_place)
          slot = next(slot);
        slots_[slot] = static_cast<Place>(place);
      }
    is_hashed_.store(true, std::memory_order_release);
  }

  std::size_t first_slot(std::uint64_t id) const
  {
    return static_cast<std::size_t>(hash_.finish(hash_.add(0, 0, id)) >> (64 - bits_));
  }

  std::size_t next(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }

  const Loaded_points<Dimension>& part_;
  const std::uint64_t end_;
  mutable std::atomic<std::size_t> asked_ = 0;
  const Sequence_hash<1> hash_ = Sequence_hash<1>(1, seed_of_process());
  mutable std::atomic<bool> is_hashed_ = false;
  mutable std::mutex mutex_;
  mutable int bits_ = 0; // of a slot
  mutable std::vector<Place> slots_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_ID_PLACES_H
