// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SEARCH_H

// The searches for near points by slabs, as those see them who know the types of the user.
//
// A program compiles them, unless it defines CGAL_THICK_INTERSECTION_D_COMPILED. Then it links the
// library that src/near_points.cpp makes.

#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#ifndef CGAL_THICK_INTERSECTION_D_COMPILED
#include <CGAL/Thick_intersection_d/internal/slabs/near_search.inc>
#endif

#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether the threads of a program may share slabs. The searches of the library can do this.
#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
inline constexpr bool may_share_slabs = true;
#else
inline constexpr bool may_share_slabs = has_tbb;
#endif

// Gives the near pairs of points to the taker. `Number` is what slabs have: std::int32_t if the
// scale of the task is usable, or double. Returns false iff the search was stopped.
template <int Dimension, class Number, bool MayBeShared>
bool search_near(Near_points<Dimension>& points, const Near_task<Dimension>& task,
                 Result_taker& taker);

// Collects the pairs of few points: those of one run if `b` is null, or those of two runs.
template <int Dimension>
void collect_few_pairs(const Run<Dimension, double>& a, const Run<Dimension, double>* b,
                       const Near_question<double>& question, Near_pairs& found,
                       const Flush& flush);

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template class Narrow_scale<2>;
extern template bool search_near<2, double, true>(
  Near_points<2>&, const Near_task<2>&, Result_taker&);
extern template bool search_near<2, std::int32_t, true>(
  Near_points<2>&, const Near_task<2>&, Result_taker&);
extern template void collect_few_pairs<2>(
  const Run<2, double>&, const Run<2, double>*, const Near_question<double>&, Near_pairs&,
  const Flush&);
extern template class Narrow_scale<3>;
extern template bool search_near<3, double, true>(
  Near_points<3>&, const Near_task<3>&, Result_taker&);
extern template bool search_near<3, std::int32_t, true>(
  Near_points<3>&, const Near_task<3>&, Result_taker&);
extern template void collect_few_pairs<3>(
  const Run<3, double>&, const Run<3, double>*, const Near_question<double>&, Near_pairs&,
  const Flush&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SEARCH_H
