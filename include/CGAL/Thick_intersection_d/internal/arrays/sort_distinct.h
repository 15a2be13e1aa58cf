// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_SORT_DISTINCT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_SORT_DISTINCT_H

// Sorts sequences of distinct numbers, most of which are short.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The numbers of a run, at most.
inline constexpr std::ptrdiff_t max_run_size = 32;

// How runs are sorted and merged.
struct Run_sorter
{
  std::ptrdiff_t size_step; // merge() takes runs whose size is a multiple of it

  // Sorts the first `size` of `numbers`, which are a run or fewer, to `sorted`. Both have room for
  // `max_run_size` numbers.
  void (*sort)(const std::uint32_t* numbers, std::uint32_t size, std::uint32_t* sorted);

  // Merges two sorted runs of `size` numbers, one behind the other, to `merged`. A number behind
  // them can be read.
  void (*merge)(const std::uint32_t* run, std::ptrdiff_t size, std::uint32_t* merged);
};

// Sorts a run of distinct numbers by rank: the rank of a number is the count of smaller numbers.
// `lane_count` ranks are counted at a time, in loops without branches, which compilers turn into
// vector instructions. Takes quadratic time.
BOOST_NOINLINE inline
void sort_run_by_ranks(const std::uint32_t* first, std::uint32_t run_size, std::uint32_t* sorted)
{
  constexpr std::ptrdiff_t lane_count = 8;
  const std::ptrdiff_t size = run_size;
  // Vector instructions compare signed numbers. Flipping the top bit keeps the order.
  std::int32_t numbers[max_run_size];
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
      sorted[rank[lane]] = static_cast<std::uint32_t>(numbers[i + lane]) ^ 0x80000000u;
  }
}

// Merges two sorted runs of `size` numbers, one behind the other, to `merged`. The smaller half of
// the numbers is merged from the front and the larger half from the back. So neither run ends
// before the loop does, and no branch depends on the numbers.
BOOST_NOINLINE inline
void merge_two_runs(const std::uint32_t* run, std::ptrdiff_t size, std::uint32_t* merged)
{
  const std::uint32_t *a = run, *b = run + size;
  const std::uint32_t *last_a = b - 1, *last_b = b + size - 1;
  for(std::ptrdiff_t i = 0; i < size; ++i) {
    const bool is_b_first = *b < *a;
    merged[i] = is_b_first ? *b : *a;
    b += is_b_first;
    a += !is_b_first;
    const bool is_a_last = *last_b < *last_a;
    merged[2 * size - 1 - i] = is_a_last ? *last_a : *last_b;
    last_a -= is_a_last;
    last_b -= !is_a_last;
  }
}

// By plain loops.
inline constexpr Run_sorter plain_run_sorter = {1, sort_run_by_ranks, merge_two_runs};

// Sorts distinct numbers, in `memory`. They are cut into runs of equal size, which are sorted and
// then merged by twos. What is missing in the last runs is filled with the largest number.
BOOST_NOINLINE inline
void sort_distinct(std::uint32_t* first, std::uint32_t* last, Buffer<std::uint32_t>& memory,
                   const Run_sorter& sorter = plain_run_sorter)
{
  const std::ptrdiff_t size = last - first;
  std::ptrdiff_t run_count = 1;
  while(run_count * max_run_size < size)
    run_count *= 2;
  const std::ptrdiff_t run_step = run_count * sorter.size_step;
  const std::ptrdiff_t run_size = (size + run_step - 1) / run_step * sorter.size_step;
  const std::ptrdiff_t end = run_count * run_size;
  const std::ptrdiff_t room = end + max_run_size;
  std::uint32_t* from = memory.require(static_cast<std::size_t>(2 * room));
  std::uint32_t* to = from + room;
  std::fill(std::copy(first, last, to), to + end, (std::numeric_limits<std::uint32_t>::max)());
  for(std::ptrdiff_t run = 0; run < size; run += run_size)
    sorter.sort(to + run, static_cast<std::uint32_t>((std::min)(size - run, run_size)), from + run);
  std::copy(to + size, to + end, from + size);

  // Each run of `sorted` numbers in `from` is sorted.
  for(std::ptrdiff_t sorted = run_size; sorted < end; sorted *= 2) {
    for(std::ptrdiff_t run = 0; run < end; run += 2 * sorted)
      sorter.merge(from + run, sorted, to + run);
    std::swap(from, to);
  }
  std::copy_n(from, size, first);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_SORT_DISTINCT_H
