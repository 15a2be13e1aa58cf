// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIRST_EQUAL_PAIR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIRST_EQUAL_PAIR_H

// Finds points at distance zero, by hashing coordinates.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Finds the lexicographically smallest pair of equal points, by hashing. The coordinates must be
// doubles, or of a type that doubles hold.
template <class Elements>
class First_equal_pair
{
  // Of the points, or 0 if their type does not tell it.
  static constexpr int type_dimension = dimension_or<typename Elements::value_type>(0);

public:
  First_equal_pair(const Elements& points, int dimension, std::uint64_t seed)
    : points_(points), dimension_(dimension), hash_(dimension, seed),
      slot_bits_(hash_table_bits(points.size())), heads_(std::size_t(1) << slot_bits_),
      next_(points.size())
  {}

  // Returns the pair, if there is one, in expected linear time. The search may be cancelled. Each
  // point is one step of progress.
  template <class Progress>
  BOOST_NOINLINE std::optional<Position_pair> find(Progress& progress)
  {
    // Invariant: the slots hold the first point of each set of equal points before i.
    std::optional<Position_pair> first;
    for(std::size_t i = 0; i < points_.size(); ++i) {
      if(i % batch_size == 0 && !progress.advance((std::min)(batch_size, points_.size() - i)))
        return first;
      if(step_count_ > max_equality_steps_per_point * points_.size())
        hash_again(i);
      const std::size_t other = find_or_insert(i);
      if(other < (first ? first->first : i))
        first = Position_pair(other, i);
      if(first && first->first == 0)
        return first;
    }
    return first;
  }

private:
  static constexpr std::size_t batch_size = 512;

  // Returns the first point that is equal to point i: another one, or i.
  std::size_t find_or_insert(std::size_t i)
  {
    Place& head = heads_[slot(i)];
    for(Place other = head; other != 0; other = next_[other - 1]) {
      if(are_equal(other - 1, i))
        return other - 1;
      ++step_count_;
    }
    next_[i] = head;
    head = static_cast<Place>(i) + 1;
    return i;
  }

  // Inserts the points before i by another hash, if the points were made for the first one. No
  // input is made for this one.
  void hash_again(std::size_t i)
  {
    std::uint64_t seed = seed_of_process() + ++hash_count_;
    hash_ = Sequence_hash<type_dimension>(dimension(), random_word(seed));
    heads_.assign(heads_.size(), 0);
    step_count_ = 0;
    for(std::size_t j = 0; j < i; ++j)
      find_or_insert(j);
  }

  int dimension() const { return type_dimension != 0 ? type_dimension : dimension_; }

  std::size_t slot(std::size_t i) const
  {
    std::uint64_t sum = 0;
    for(int axis = 0; axis < dimension(); ++axis)
      sum = hash_.add(sum, axis, key(i, axis));
    return hash_.finish(sum) >> (64 - slot_bits_);
  }

  bool are_equal(std::size_t i, std::size_t j) const
  {
    for(int axis = 0; axis < dimension(); ++axis)
      if(key(i, axis) != key(j, axis))
        return false;
    return true;
  }

  std::uint64_t key(std::size_t i, int axis) const
  {
    return radix_key(static_cast<double>(coordinate(points_[i], axis)));
  }

  const Elements& points_;
  int dimension_;
  Sequence_hash<type_dimension> hash_;
  std::uint64_t hash_count_ = 0; // of other hashes
  int slot_bits_;
  std::vector<Place> heads_; // by slot: 1 + the last point in the slot, or 0
  std::vector<Place> next_;  // by point: 1 + the point before it in the slot, or 0
  std::size_t step_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIRST_EQUAL_PAIR_H
