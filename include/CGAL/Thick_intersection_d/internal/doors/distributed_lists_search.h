// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_LISTS_SEARCH_H

// The search behind distributed_fixed_radius_neighbor_lists(). Each process makes lists of the
// points that it has, as the search of one process does, and sends them to the holders of the
// points.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>
#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>
#include <CGAL/Thick_intersection_d/internal/doors/Distributed_lists.h>
#include <CGAL/Thick_intersection_d/internal/doors/distributed_search.h>
#include <CGAL/Thick_intersection_d/internal/doors/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/reports/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/reports/mutual_neighbors.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the lists of the points that this process has, of the first set if there are two, as
// places. If the search was stopped here, each pair of one set is in both of its lists or in none.
template <class ConcurrencyTag, class Carried, class Sets, class NT, class NamedParameters>
Neighbor_lists
collect_neighbors_here(const Communicator& comm,
                       const std::vector<Part_points<Carried>>& points, const Sets& sets,
                       const Distance_bound<NT>& bound, const NamedParameters& np)
{
  std::optional<Neighbor_collector<ConcurrencyTag>> collector;
  run_together(comm, [&] {
    check_list_size(points.front().size());
    check_list_size(points.back().size());
    collector.emplace(points.front().size());
  });
  bool is_complete = false;
  search_together(comm, np, [&](const auto& watched_np) {
    if constexpr(Sets::are_two) {
      const auto add = [&](std::size_t i, std::size_t j) { collector->add(i, j); };
      is_complete = report_pairs_here<ConcurrencyTag>(points, sets, bound, add, watched_np);
    }
    else
      is_complete = report_pairs_here<ConcurrencyTag>(points, sets, bound, *collector, watched_np);
    return is_complete;
  });
  Neighbor_lists lists;
  run_together(comm, [&] {
    lists = collector->lists(!Sets::are_two);
    if(!Sets::are_two && !is_complete)
      lists = mutual_neighbors(lists);
  });
  return lists;
}

template <class ConcurrencyTag, class Elements, class Sets, class NT, class NamedParameters>
Distributed_neighbor_lists
make_distributed_lists(const Communicator& comm, const Elements& elements, const Sets& sets,
                       const Distance_bound<NT>& bound, Distributed_profile& profile,
                       const NamedParameters& np)
{
  if constexpr(!check_sent_points<Elements>())
    return Distributed_neighbor_lists();
  else {
    Phase_clock clock(profile);
    Distributed_lists lists(comm, sizes_of_sets(elements, sets)[0]);
    { // then the points are given up
      const auto points
        = distribute_points<ConcurrencyTag>(comm, elements, sets, bound, profile, clock);
      const Neighbor_lists here
        = collect_neighbors_here<ConcurrencyTag>(comm, points.sets(), sets, bound, np);
      run_together(comm, [&] { lists.pack(here, points.sets().front(), points.sets().back()); });
      clock.finish(Distributed_phase::SEARCH);
    }
    Distributed_neighbor_lists mine = lists.exchange<ConcurrencyTag>();
    profile.set_bytes_sent(Distributed_phase::LISTS, lists.size_sent());
    clock.finish(Distributed_phase::LISTS);
    return mine;
  }
}

// Makes the lists of one range on each process, or those of the first of two ranges, with neighbors
// in the second.
template <class ConcurrencyTag, class NT, class NamedParameters, class... Ranges>
Distributed_neighbor_lists
collect_distributed_neighbors(const Communicator& comm, const Distance_bound<NT>& bound,
                              Distributed_profile& profile, const NamedParameters& np,
                              Ranges&... ranges)
{
  if constexpr((check_range<ConcurrencyTag, Ranges, NamedParameters>() && ...)) {
    const auto search = [&](const auto& elements, const auto& sets) {
      return make_distributed_lists<ConcurrencyTag>(comm, elements, sets, bound, profile, np);
    };
    return with_distributed_ranges(comm, np, search, ranges...);
  }
  else
    return Distributed_neighbor_lists();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_LISTS_SEARCH_H
