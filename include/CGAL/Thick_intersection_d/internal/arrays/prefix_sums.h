// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H

// The step of a counting sort between counting the elements of buckets and moving the elements.

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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H
