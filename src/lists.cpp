// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lists of neighbors, from pairs and from the lists that slabs make of single points, for all
// kernels, in the library that programs link if they define CGAL_THICK_INTERSECTION_D_COMPILED.

#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/machine/Per_thread.h>
#include <CGAL/Thick_intersection_d/internal/slabs/List_bins.h>
#include <CGAL/Thick_intersection_d/internal/slabs/list_search.inc>

#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template bool search_near<2, double, true>(
  Near_points<2>&, const Near_task<2>&, List_taker&);
template bool search_near<2, std::int32_t, true>(
  Near_points<2>&, const Near_task<2>&, List_taker&);
template bool search_near<3, double, true>(
  Near_points<3>&, const Near_task<3>&, List_taker&);
template bool search_near<3, std::int32_t, true>(
  Near_points<3>&, const Near_task<3>&, List_taker&);
template class Per_thread<Neighbor_bins>;
template class Per_thread<List_bins>;
template class Callback_taker<One_set, Neighbor_collector, List_taker>;
template Neighbor_lists Neighbor_collector::lists_of(
  Per_thread<Neighbor_bins>&, bool, Neighbor_lists&&);
template Neighbor_lists Neighbor_collector::lists_of(
  Per_thread<List_bins>&, bool, Neighbor_lists&&);
template Neighbor_lists mutual_neighbors(const Neighbor_lists&);

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL
