// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_PREFIX_SUMS_H

// The step between counting elements by bucket and moving them there.

#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Replaces each count by the sum of the counts before it, and returns the sum of all counts.
//
// The sums are where the elements of each bucket begin. A loop that then writes each element to
// next[bucket]++ leaves behind where the elements of each bucket end.
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
