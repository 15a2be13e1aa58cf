// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_JOIN_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_JOIN_SEARCH_H

// The joins of points in common cells, as those see them who know the types of the user.
//
// A program compiles them, unless it defines CGAL_THICK_INTERSECTION_D_COMPILED. Then it links the
// library that src/closest_pair.cpp makes.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#ifndef CGAL_THICK_INTERSECTION_D_COMPILED
#include <CGAL/Thick_intersection_d/internal/closest_pair/join_search.inc>
#endif

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Gives the pairs of the first `size` points within a distance to the taker, and other pairs that
// are in a common cell. Gives up if points are crowded. do_cells_fit() must hold.
template <int Dimension>
Joined join_first_points(Near_points<Dimension>& points, const Join_task<Dimension>& task,
                         std::size_t size, double distance, Pair_taker& taker);

// Gives the closest pairs to the taker, and others. Gives up if points are crowded or equal, or if
// doubles are too coarse.
template <int Dimension>
Joined join_samples(Near_points<Dimension>& points, const Join_task<Dimension>& task,
                    Closest_taker& taker);

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template Joined join_first_points<2>(
  Near_points<2>&, const Join_task<2>&, std::size_t, double, Pair_taker&);
extern template Joined join_samples<2>(Near_points<2>&, const Join_task<2>&, Closest_taker&);
extern template Joined join_first_points<3>(
  Near_points<3>&, const Join_task<3>&, std::size_t, double, Pair_taker&);
extern template Joined join_samples<3>(Near_points<3>&, const Join_task<3>&, Closest_taker&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_JOIN_SEARCH_H
