// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_RADIX_SORT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_RADIX_SORT_H

// Radix sort of integers, and of doubles as integers in the same order. It takes linear time, as in
// [L] (doc/design.md).

#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Keyed_value
{
  std::uint64_t key;
  std::uint32_t value;
};

// Returns an integer for a number that is not NaN. The integers have the order of the numbers; -0
// and 0 have the same integer.
inline std::uint64_t radix_key(double x)
{
  if(x == 0)
    x = 0; // -0 as well
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  const std::uint64_t sign = std::uint64_t(1) << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// Sorts a few items by the keys: merges sorted runs of one, two, four items and so on. It compiles
// faster than the stable sort of the standard library.
inline void merge_sort(std::vector<Keyed_value>& items)
{
  const std::size_t size = items.size();
  std::vector<Keyed_value> merged(size);
  for(std::size_t length = 1; length < size; length *= 2) {
    for(std::size_t begin = 0; begin < size; begin += 2 * length) {
      const Keyed_value* const first = items.data() + begin;
      const Keyed_value* const middle = items.data() + (std::min)(begin + length, size);
      const Keyed_value* const last = items.data() + (std::min)(begin + 2 * length, size);
      std::merge(first, middle, middle, last, merged.data() + begin,
                 [](const Keyed_value& a, const Keyed_value& b) { return a.key < b.key; });
    }
    items.swap(merged);
  }
}

// Sorts by the keys, with one pass per digit in which keys differ. Values of equal keys keep their
// order.
inline void radix_sort(std::vector<Keyed_value>& items)
{
  constexpr int digit_bits = 11;
  constexpr std::size_t digit_count = std::size_t(1) << digit_bits;
  if(items.size() < digit_count / 8) { // a pass would spend its time on the counters
    merge_sort(items);
    return;
  }

  std::uint64_t differing = 0;
  for(const Keyed_value& item : items)
    differing |= item.key ^ items.front().key;

  std::vector<Keyed_value> sorted(items.size());
  std::vector<std::size_t> next(digit_count);
  for(int shift = 0; shift < 64; shift += digit_bits) {
    const auto digit = [&](std::uint64_t key) { return (key >> shift) & (digit_count - 1); };
    if(digit(differing) == 0)
      continue;
    std::fill(next.begin(), next.end(), 0);
    for(const Keyed_value& item : items)
      ++next[digit(item.key)];
    replace_by_prefix_sums(next.data(), next.data() + next.size());
    for(const Keyed_value& item : items)
      sorted[next[digit(item.key)]++] = item;
    items.swap(sorted);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_RADIX_SORT_H
