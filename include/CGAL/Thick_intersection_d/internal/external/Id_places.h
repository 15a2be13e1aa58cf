// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_ID_PLACES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_ID_PLACES_H

// The places of points with given ids.

#include <CGAL/Thick_intersection_d/internal/external/Loaded_points.h>

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
// order of the range, so its ids ascend. If a search asks for many, all ids are sorted. Several
// threads may ask at once.
template <int Dimension>
class Id_places
{
public:
  // Finds ids of points that the part owns, which are less than `end`, at most 2^32.
  Id_places(const Loaded_points<Dimension>& part, std::uint64_t end) : part_(part), end_(end) {}

  BOOST_NOINLINE std::size_t operator()(std::uint64_t id) const
  {
    if(!is_sorted_.load(std::memory_order_acquire)) {
      if(asked_.fetch_add(1, std::memory_order_relaxed) < part_.owned() / points_per_question)
        return find_in_lists(id);
      sort();
    }
    return static_cast<std::uint32_t>(
      *std::lower_bound(sorted_.begin(), sorted_.end(), id << bits_of_place));
  }

private:
  // Looking into all lists takes about as long as sorting so many ids.
  static constexpr std::size_t points_per_question = 64;

  static constexpr int bits_of_place = 32;

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

  void sort() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(is_sorted_.load(std::memory_order_relaxed))
      return;
    for(std::size_t place = 0; place < part_.owned(); ++place)
      if(const std::uint64_t id = part_.columns().ids[place]; id < end_)
        sorted_.push_back(id << bits_of_place | place);
    std::sort(sorted_.begin(), sorted_.end());
    is_sorted_.store(true, std::memory_order_release);
  }

  const Loaded_points<Dimension>& part_;
  const std::uint64_t end_;
  mutable std::atomic<std::size_t> asked_ = 0;
  mutable std::atomic<bool> is_sorted_ = false;
  mutable std::mutex mutex_;
  mutable std::vector<std::uint64_t> sorted_; // ids, each with its place in the lower half
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_ID_PLACES_H
