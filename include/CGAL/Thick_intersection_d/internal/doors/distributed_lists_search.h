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
#include <CGAL/Thick_intersection_d/internal/doors/Distributed_points.h>
#include <CGAL/Thick_intersection_d/internal/doors/distributed_search.h>
#include <CGAL/Thick_intersection_d/internal/doors/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
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
                       const std::vector<Distributed_set<Carried>>& points, const Sets& sets,
                       const Distance_bound<NT>& bound, const NamedParameters& np)
{
  std::optional<Neighbor_collector<ConcurrencyTag>> collector;
  run_together(comm, [&] {
    check_list_size(points.front().part.size());
    check_list_size(points.back().part.size());
    collector.emplace(points.front().part.size());
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

// Finds the lists, which are then to be sent. The points are given up when it returns.
template <class ConcurrencyTag, class Elements, class Sets, class NT, class NamedParameters>
void find_distributed_lists(const Communicator& comm, const Elements& elements, const Sets& sets,
                            const Distance_bound<NT>& bound, Distributed_lists& lists,
                            Distributed_profile& profile, Phase_clock& clock,
                            const NamedParameters& np)
{
  const auto points
    = distribute_points<ConcurrencyTag>(comm, elements, sets, bound, profile, clock);
  const Neighbor_lists here
    = collect_neighbors_here<ConcurrencyTag>(comm, points.sets(), sets, bound, np);
  run_together(comm, [&] { lists.pack(here, points.sets().front(), points.sets().back()); });
  clock.finish(Distributed_phase::SEARCH);
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
    std::size_t size = elements.size();
    if constexpr(Sets::are_two)
      size = sets.first_size;
    Distributed_lists lists(comm, size);
    find_distributed_lists<ConcurrencyTag>(comm, elements, sets, bound, lists, profile, clock, np);
    Distributed_neighbor_lists mine = lists.exchange<ConcurrencyTag>();
    profile.set_bytes_sent(Distributed_phase::LISTS, lists.size_sent());
    clock.finish(Distributed_phase::LISTS);
    return mine;
  }
}

// Makes the lists of one range on each process.
template <class ConcurrencyTag, class Range, class NT, class NamedParameters>
Distributed_neighbor_lists
collect_distributed_neighbors(const Communicator& comm, Range& range,
                              const Distance_bound<NT>& bound, Distributed_profile& profile,
                              const NamedParameters& np)
{
  if constexpr(check_range<ConcurrencyTag, Range, NamedParameters>())
    return with_distributed_range(comm, range, np, [&](const auto& elements, const auto& sets) {
      return make_distributed_lists<ConcurrencyTag>(comm, elements, sets, bound, profile, np);
    });
  else
    return Distributed_neighbor_lists();
}

// Makes the lists of the first of two ranges on each process, with neighbors in the second.
template <class ConcurrencyTag, class RangeA, class RangeB, class NT, class NamedParameters>
Distributed_neighbor_lists
collect_distributed_neighbors(const Communicator& comm, RangeA& range_a, RangeB& range_b,
                              const Distance_bound<NT>& bound, Distributed_profile& profile,
                              const NamedParameters& np)
{
  if constexpr(!check_range<ConcurrencyTag, RangeA, NamedParameters>())
    return Distributed_neighbor_lists();
  else if constexpr(!check_range<ConcurrencyTag, RangeB, NamedParameters>())
    return Distributed_neighbor_lists();
  else {
    const auto search = [&](const auto& elements, const auto& sets) {
      return make_distributed_lists<ConcurrencyTag>(comm, elements, sets, bound, profile, np);
    };
    return with_distributed_ranges(comm, range_a, range_b, np, search);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_LISTS_SEARCH_H
