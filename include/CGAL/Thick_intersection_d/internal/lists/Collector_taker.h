// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_COLLECTOR_TAKER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_COLLECTOR_TAKER_H

// Hands the results of a search by slabs to a collector: pairs, or the lists of single points.

#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Callback_taker.h>
#include <CGAL/Thick_intersection_d/internal/reports/List_bins.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Collector_taker final
  : public Callback_taker<One_set, Neighbor_collector, List_taker>
{
public:
  explicit Collector_taker(Neighbor_collector& collector)
    : Callback_taker<One_set, Neighbor_collector, List_taker>(One_set(), collector)
  {}

  List_bins& local_lists() override { return callback_.local_lists(); }
};

inline Collector_taker taker_of(const One_set&, Neighbor_collector& collector)
{
  return Collector_taker(collector);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_COLLECTOR_TAKER_H
