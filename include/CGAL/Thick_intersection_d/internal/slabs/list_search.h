// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_SEARCH_H

// The search by slabs for the neighbors of each point, beside that of near_search.h for pairs.

#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#ifndef CGAL_THICK_INTERSECTION_D_COMPILED
#include <CGAL/Thick_intersection_d/internal/slabs/list_search.inc>
#endif

#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Gives the near pairs of the points of one set to the taker, or the complete lists of single
// points, as List_route.h says. Otherwise like the function for pairs.
template <int Dimension, class Number, bool MayBeShared>
bool search_near(Near_points<Dimension>& points, const Near_task<Dimension>& task,
                 List_taker& taker);

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template bool search_near<2, double, true>(
  Near_points<2>&, const Near_task<2>&, List_taker&);
extern template bool search_near<2, std::int32_t, true>(
  Near_points<2>&, const Near_task<2>&, List_taker&);
extern template bool search_near<3, double, true>(
  Near_points<3>&, const Near_task<3>&, List_taker&);
extern template bool search_near<3, std::int32_t, true>(
  Near_points<3>&, const Near_task<3>&, List_taker&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_SEARCH_H
