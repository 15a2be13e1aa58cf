// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SEARCHED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SEARCHED_POINTS_H

// The points of a part, as a search in memory takes them.

#include <CGAL/Thick_intersection_d/internal/arrays/Hash_table.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>

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

// The points of a part: list by list, those that it owns first.
template <int Dimension>
struct Loaded_points
{
  std::vector<Stored_point<Dimension>> points;
  std::size_t owned = 0;
  std::vector<std::size_t> begins; // of the lists of owned points
};

// A search reports points by numbers of 32 bits. If it reported places, the ids of both points of
// each pair would have to be looked up, and they are all over the memory. So the number of a point
// that the part owns is its id, with the first bit set, if that has room. The number of any other
// point is its place, which has less than 32 bits.
//
// Only for near ties, a point is found by its id. Most searches ask for a few places. They are
// found in the lists of a part: each list has the order of the range, so its ids ascend. If a
// search asks for many, all ids are hashed. Several threads may ask at once.
template <int Dimension>
class Searched_points
{
public:
  using value_type = Stored_point<Dimension>;

  // The part stays as it is.
  explicit Searched_points(const Loaded_points<Dimension>& part) : part_(part) {}

  std::size_t size() const { return part_.points.size(); }
  const value_type& operator[](std::size_t place) const { return part_.points[place]; }

  Place number(std::size_t place) const
  {
    return static_cast<Place>(has_short_id(place) ? first_id + part_.points[place].id : place);
  }

  // A place is its own place.
  std::size_t place(std::size_t number) const
  {
    return is_id(number) ? place_of(short_id(number)) : number;
  }

  // Whether a number is an id. Then short_id() tells which.
  static bool is_id(std::size_t number) { return number >= first_id; }
  static std::uint64_t short_id(std::size_t number) { return number - first_id; }

  std::uint64_t id(std::size_t number) const
  {
    return is_id(number) ? short_id(number) : part_.points[number].id;
  }

  bool is_owned(std::size_t number) const { return is_id(number) || number < part_.owned; }

private:
  static constexpr std::size_t first_id = std::size_t(1) << 31;

  // Looking into all lists takes about as long as hashing so many ids.
  static constexpr std::size_t points_per_question = 64;

  bool has_short_id(std::size_t place) const
  {
    return place < part_.owned && part_.points[place].id < max_place - first_id;
  }

  BOOST_NOINLINE std::size_t place_of(std::uint64_t id) const
  {
    if(!is_hashed_.load(std::memory_order_acquire)) {
      if(asked_.fetch_add(1, std::memory_order_relaxed) < part_.owned / points_per_question)
        return find_in_lists(id);
      hash();
    }
    return places_[slot_of(id)];
  }

  std::size_t find_in_lists(std::uint64_t id) const
  {
    const value_type* const points = part_.points.data();
    std::size_t last = part_.owned;
    for(std::size_t list = part_.begins.size(); list-- > 0; last = part_.begins[list]) {
      const value_type* const found
        = std::lower_bound(points + part_.begins[list], points + last, id,
                           [](const value_type& point, std::uint64_t i) { return point.id < i; });
      if(found != points + last && found->id == id)
        return static_cast<std::size_t>(found - points);
    }
    return 0; // there is no such id
  }

  void hash() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(is_hashed_.load(std::memory_order_relaxed))
      return;
    places_ = Hash_table<Place, max_place>(part_.owned);
    for(std::size_t place = 0; place < part_.owned; ++place)
      if(has_short_id(place))
        places_[slot_of(part_.points[place].id)] = static_cast<Place>(place);
    is_hashed_.store(true, std::memory_order_release);
  }

  // Returns the slot of an id, or the free one where it belongs.
  std::size_t slot_of(std::uint64_t id) const
  {
    return places_.find(hash_.finish(hash_.add(0, 0, id)),
                        [&](Place place) { return part_.points[place].id == id; });
  }

  const Loaded_points<Dimension>& part_;
  const Sequence_hash<1> hash_ = Sequence_hash<1>(1, seed_of_process());
  mutable std::atomic<std::size_t> asked_ = 0;
  mutable std::atomic<bool> is_hashed_ = false;
  mutable std::mutex mutex_;
  mutable Hash_table<Place, max_place> places_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SEARCHED_POINTS_H
