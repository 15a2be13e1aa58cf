// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SEARCH_H

// The searches for near points by slabs, as those see them who know the types of the user.

#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Flush.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/slabs/near_search.inc>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether the threads of a program may share slabs.
inline constexpr bool may_share_slabs = has_tbb;

// Gives the near pairs of points to the taker. `Number` is what slabs have: std::int32_t if the
// scale of the task is usable, or double. Returns false iff the search was stopped.
template <int Dimension, class Number, bool MayBeShared>
bool search_near_pairs(Near_points<Dimension>& points, const Near_task<Dimension>& task,
                       Result_taker& taker);

// The same for the lists of neighbors of one set, as List_route.h says.
template <int Dimension, class Number, bool MayBeShared>
bool search_near_lists(Near_points<Dimension>& points, const Near_task<Dimension>& task,
                       List_taker& taker);

// Collects the pairs of few points: those of one run if `b` is null, or those of two runs.
template <int Dimension>
void collect_few_pairs(const Run<Dimension, double>& a, const Run<Dimension, double>* b,
                       const Near_question<double>& question, Near_pairs& found,
                       const Flush& flush);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NEAR_SEARCH_H
