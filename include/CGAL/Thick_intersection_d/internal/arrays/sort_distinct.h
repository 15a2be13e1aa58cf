// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_SORT_DISTINCT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_SORT_DISTINCT_H

// Sorts short sequences of distinct numbers.

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Sorts distinct numbers. A short sequence is sorted by rank: the rank of a number is the count of
// smaller numbers. `lane_count` ranks are counted at a time, in loops without branches, which
// compilers turn into vector instructions.
inline void sort_distinct(std::uint32_t* first, std::uint32_t* last)
{
  constexpr std::ptrdiff_t lane_count = 8;
  constexpr std::ptrdiff_t max_size = 256; // counting ranks takes quadratic time
  const std::ptrdiff_t size = last - first;
  if(size > max_size) {
    std::sort(first, last);
    return;
  }
  // Vector instructions compare signed numbers. Flipping the top bit keeps the order.
  std::int32_t numbers[max_size];
  for(std::ptrdiff_t i = 0; i < size; ++i)
    numbers[i] = static_cast<std::int32_t>(first[i] ^ 0x80000000u);
  std::fill(numbers + size, numbers + (size + lane_count - 1) / lane_count * lane_count, 0);
  for(std::ptrdiff_t i = 0; i < size; i += lane_count) {
    std::int32_t rank[lane_count] = {};
    for(std::ptrdiff_t j = 0; j < size; ++j)
      for(std::ptrdiff_t lane = 0; lane < lane_count; ++lane)
        rank[lane] += numbers[j] < numbers[i + lane];
    const std::ptrdiff_t count = (std::min)(lane_count, size - i);
    for(std::ptrdiff_t lane = 0; lane < count; ++lane)
      first[rank[lane]] = static_cast<std::uint32_t>(numbers[i + lane]) ^ 0x80000000u;
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_SORT_DISTINCT_H
