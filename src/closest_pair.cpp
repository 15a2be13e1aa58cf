// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The joins of points in common cells, for all kernels, in the library that programs link if they
// define CGAL_THICK_INTERSECTION_D_COMPILED.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/join_search.inc>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template Joined join_first_points<2>(
  Near_points<2>&, const Join_task<2>&, std::size_t, double, Pair_taker&);
template Joined join_samples<2>(Near_points<2>&, const Join_task<2>&, Closest_taker&);
template Joined join_first_points<3>(
  Near_points<3>&, const Join_task<3>&, std::size_t, double, Pair_taker&);
template Joined join_samples<3>(Near_points<3>&, const Join_task<3>&, Closest_taker&);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
