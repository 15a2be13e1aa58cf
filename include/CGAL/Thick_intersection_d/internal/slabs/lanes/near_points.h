// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_H

// Collects candidates by the instructions that the processor has. All versions collect the same
// pairs in the same order, but for pairs that the filter does not decide: these may also be left
// out where they are beyond the bound.

#include <CGAL/Thick_intersection_d/internal/slabs/lanes/near_points_avx512.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension, class Flush>
void collect_within(const Run<Dimension>& run, double reach, const Distance_filter& filter,
                    Candidates& candidates, const Flush& flush)
{
#ifdef CGAL_THICK_INTERSECTION_D_HAS_AVX512_CODE
  if(has_avx512())
    return collect_within_avx512(run, reach, filter, candidates, flush);
#endif
  collect_within_plain(run, reach, filter, candidates, flush);
}

template <int Dimension, class Flush>
void collect_between(const Run<Dimension>& a, const Run<Dimension>& b, double reach,
                     const Distance_filter& filter, Candidates& candidates, const Flush& flush)
{
#ifdef CGAL_THICK_INTERSECTION_D_HAS_AVX512_CODE
  if(has_avx512())
    return collect_between_avx512(a, b, reach, filter, candidates, flush);
#endif
  collect_between_plain(a, b, reach, filter, candidates, flush);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_POINTS_H
