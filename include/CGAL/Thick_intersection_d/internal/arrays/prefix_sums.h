// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H

// The step of a counting sort between counting the elements of buckets and moving the elements.

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Replaces each count by the sum of the counts before it, and returns the sum of all counts.
//
// If the counts are of buckets, each sum is the place where its bucket begins. A loop that writes
// each element to next[bucket]++ turns the sums into the places where the buckets end.
template <class Count>
Count replace_by_prefix_sums(Count* first, Count* last)
{
  Count sum = 0;
  for(; first != last; ++first)
    sum += std::exchange(*first, sum);
  return sum;
}

// The same of several blocks of elements, which are counted and moved at the same time: counts[b *
// size + i] are the elements of bucket i in block b. Replaces each count by the sum of the counts
// of its bucket in the blocks before it. Sets the totals of the buckets, which must be zero.
//
// The counts of a group of buckets, one cache line of each block, are one task.
template <class Count, class Total>
BOOST_NOINLINE void replace_by_sums_over_blocks(const Threads& threads, Count* counts,
                                                std::size_t blocks, std::size_t size,
                                                Total* totals)
{
  const std::size_t group = blocks == 1 ? size : 64 / sizeof(Count);
  threads.run_blocks((size + group - 1) / group, [&](std::size_t g, std::size_t end) {
    for(; g != end; ++g)
      for(std::size_t block = 0; block != blocks; ++block) {
        Count* const row = counts + block * size;
        for(std::size_t i = g * group; i != (std::min)((g + 1) * group, size); ++i) {
          const Total before = totals[i];
          totals[i] += std::exchange(row[i], static_cast<Count>(before));
        }
      }
  });
}

// Adds the totals of the buckets before each bucket to the counts of a block. These become the
// places where the elements of the block go.
template <class Count, class Total>
BOOST_NOINLINE void add_begins(Count* counts, const Total* begins, std::size_t size)
{
  for(std::size_t i = 0; i != size; ++i)
    counts[i] += static_cast<Count>(begins[i]);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H
