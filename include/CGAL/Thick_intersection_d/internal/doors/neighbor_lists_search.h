// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEIGHBOR_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEIGHBOR_LISTS_SEARCH_H

// The search behind fixed_radius_neighbor_lists().

#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/doors/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/reports/mutual_neighbors.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag, class Elements, class NT, class NamedParameters>
Neighbor_lists collect_neighbors(const Elements& points, const Distance_bound<NT>& bound,
                                 const NamedParameters& np)
{
  if(points.size() > (std::numeric_limits<Neighbor_lists::Position>::max)())
    throw std::length_error("There are more points than lists of neighbors have positions for.");
  Neighbor_collector<ConcurrencyTag> collector(points.size());
  if(report_near_pairs<ConcurrencyTag>(points, One_set(), bound, collector, np))
    return collector.lists();
  return mutual_neighbors(collector.lists());
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEIGHBOR_LISTS_SEARCH_H
