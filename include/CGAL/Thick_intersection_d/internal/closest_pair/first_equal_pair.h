// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIRST_EQUAL_PAIR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIRST_EQUAL_PAIR_H

// Finds points at distance zero, by hashing coordinates.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the lexicographically smallest pair of equal points, in expected linear time. The
// coordinates are to be doubles, or of a type that doubles hold.
template <class Elements>
std::optional<Position_pair> first_equal_pair(const Elements& points, int dimension)
{
  const auto key = [&](std::size_t i, int axis) {
    return radix_key(static_cast<double>(coordinate(points[i], axis)));
  };
  const auto are_equal = [&](std::size_t i, std::size_t j) {
    for(int axis = 0; axis < dimension; ++axis)
      if(key(i, axis) != key(j, axis))
        return false;
    return true;
  };

  const std::size_t slot_count = hash_table_size(points.size());
  std::vector<Place> slots(slot_count); // 1 + a position, or 0

  // Invariant: the slots hold the first point of each set of equal points before i.
  std::optional<Position_pair> first;
  for(std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t hash = 0;
    for(int axis = 0; axis < dimension; ++axis)
      hash = add_to_hash(hash, key(i, axis));
    std::size_t slot = finish_hash(hash) & (slot_count - 1);
    while(slots[slot] != 0 && !are_equal(slots[slot] - 1, i))
      slot = (slot + 1) & (slot_count - 1);
    if(slots[slot] == 0)
      slots[slot] = static_cast<Place>(i) + 1;
    else if(!first || slots[slot] - 1 < first->first) {
      first = Position_pair(slots[slot] - 1, i);
      if(first->first == 0)
        return first;
    }
  }
  return first;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FIRST_EQUAL_PAIR_H
