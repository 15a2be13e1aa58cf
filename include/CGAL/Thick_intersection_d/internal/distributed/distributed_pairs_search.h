// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_PAIRS_SEARCH_H

// The search behind distributed_fixed_radius_near_neighbors(). Each process searches its own points
// and those near them that it receives from other processes, as one set or two. Of each pair it has
// at least one point itself, so that no other process reports the pair.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/distributed_search.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns whether the callback can take the ids of remote points.
template <class Elements, class Callback>
constexpr bool check_callback_of_remote_ids()
{
  constexpr bool takes_ids = !Pair_target<Callback, Elements, Elements>::takes_elements;
  static_assert(takes_ids, "The elements of other processes are not here: the callback must "
                           "take two ids (std::uint64_t i, std::uint64_t j).");
  if constexpr(takes_ids)
    return check_callback<Callback, Elements, Elements>();
  else
    return false;
}

// Hands the pairs of this process to the user's callback, as ids, of one set the lesser one first.
// A pair whose points were both received belongs to another process.
template <class Carried, class Sets, class NT, class Callback, class NamedParameters>
bool report_own_pairs(const std::vector<Part_points<Carried>>& points, const Sets& sets,
                      const Distance_bound<NT>& bound, Callback& callback,
                      const NamedParameters& np, const Threads& threads)
{
  const Part_points<Carried>& first = points.front();
  const Part_points<Carried>& second = points.back();
  const auto report = [&](std::size_t i, std::size_t j) {
    if(i >= first.own_size && j >= second.own_size)
      return true;
    std::pair<std::uint64_t, std::uint64_t> ids(first.id(i), second.id(j));
    if constexpr(!Sets::are_two)
      ids = ids_in_order(ids.first, ids.second);
    return goes_on_after(callback, ids.first, ids.second);
  };
  return report_pairs_here(points, sets, bound, report, np, threads);
}

template <class Elements, class Sets, class NT, class Callback, class NamedParameters>
bool report_distributed_pairs(const Communicator& comm, const Elements& elements, const Sets& sets,
                              const Distance_bound<NT>& bound, Callback& callback,
                              Distributed_profile& profile, const NamedParameters& np,
                              const Threads& threads)
{
  if constexpr(!check_sent_points<Elements, NamedParameters>())
    return false;
  else if constexpr(!check_callback_of_remote_ids<Elements, Callback>())
    return false;
  else {
    auto&& report = pair_output(elements, elements, callback, threads);
    Phase_clock clock(profile);
    const auto points = distribute_points(comm, elements, sets, bound, profile, clock, threads);
    const bool is_complete = search_together(comm, np, [&](const auto& watched_np) {
      return report_own_pairs(points.sets(), sets, bound, report, watched_np, threads);
    });
    clock.finish(Distributed_phase::SEARCH);
    return is_complete;
  }
}

// Searches one range on each process, or two.
template <class NT, class Callback, class NamedParameters, class... Ranges>
bool search_distributed_ranges(const Communicator& comm, const Distance_bound<NT>& bound,
                               Callback& callback, Distributed_profile& profile,
                               const NamedParameters& np, const Threads& threads,
                               Ranges&... ranges)
{
  if constexpr((check_range<Ranges, NamedParameters>() && ...)) {
    const auto search = [&](const auto& elements, const auto& sets) {
      return report_distributed_pairs(comm, elements, sets, bound, callback, profile, np, threads);
    };
    return with_distributed_ranges(comm, np, search, ranges...);
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_DISTRIBUTED_PAIRS_SEARCH_H
