// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_PAIRS_SEARCH_H

// The search behind distributed_fixed_radius_near_neighbors(). Each process searches its own points
// and those near them that it receives from other processes, as one set or two. Of each pair it has
// at least one point itself, so that no other process reports the pair.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/doors/Distributed_points.h>
#include <CGAL/Thick_intersection_d/internal/doors/distributed_search.h>
#include <CGAL/Thick_intersection_d/internal/doors/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns whether the callback can take the ids of remote points.
template <class Elements, class Callback>
constexpr bool check_callback_of_remote_ids()
{
  constexpr bool takes_ids = !Pair_target<Callback, Elements, Elements>::takes_elements;
  static_assert(takes_ids, "The elements of other processes are not here: the callback is to "
                           "take two ids (std::uint64_t i, std::uint64_t j).");
  return takes_ids;
}

// Hands pairs of ids to the user's callback, the lesser id first. A pair whose points were both
// received belongs to another process.
template <class Callback>
bool call_with_ids(Callback& callback, std::uint64_t i, std::uint64_t j)
{
  if constexpr(std::is_void_v<std::invoke_result_t<Callback&, std::size_t, std::size_t>>) {
    callback(i, j);
    return true;
  }
  else
    return static_cast<bool>(callback(i, j));
}

template <class ConcurrencyTag, class Carried, class NT, class Callback, class NamedParameters>
bool report_own_pairs(const std::vector<Distributed_set<Carried>>& points, One_set,
                      const Distance_bound<NT>& bound, Callback& callback,
                      const NamedParameters& np)
{
  const Distributed_set<Carried>& set = points[0];
  const auto report = [&](std::size_t i, std::size_t j) {
    if(i >= set.own_size) // and so is j
      return true;
    const auto ids = ids_in_order(set.id(i), set.id(j));
    return call_with_ids(callback, ids.first, ids.second);
  };
  return report_pairs_here<ConcurrencyTag>(points, One_set(), bound, report, np);
}

template <class ConcurrencyTag, class Carried, class NT, class Callback, class NamedParameters>
bool report_own_pairs(const std::vector<Distributed_set<Carried>>& points, Two_sets sets,
                      const Distance_bound<NT>& bound, Callback& callback,
                      const NamedParameters& np)
{
  const auto report = [&](std::size_t i, std::size_t j) {
    if(i >= points[0].own_size && j >= points[1].own_size)
      return true;
    return call_with_ids(callback, points[0].id(i), points[1].id(j));
  };
  return report_pairs_here<ConcurrencyTag>(points, sets, bound, report, np);
}

template <class ConcurrencyTag, class Elements, class Sets, class NT, class Callback,
          class NamedParameters>
bool report_distributed_pairs(const Communicator& comm, const Elements& elements, const Sets& sets,
                              const Distance_bound<NT>& bound, Callback& callback,
                              Distributed_profile& profile, const NamedParameters& np)
{
  if constexpr(!check_sent_points<Elements>())
    return false;
  else if constexpr(!check_callback_of_remote_ids<Elements, Callback>())
    return false;
  else {
    auto&& report = pair_output<ConcurrencyTag>(elements, elements, callback);
    Phase_clock clock(profile);
    const auto points
      = distribute_points<ConcurrencyTag>(comm, elements, sets, bound, profile, clock);
    const bool is_complete = search_together(comm, np, [&](const auto& watched_np) {
      return report_own_pairs<ConcurrencyTag>(points.sets(), sets, bound, report, watched_np);
    });
    clock.finish(Distributed_phase::SEARCH);
    return is_complete;
  }
}

// Searches one range on each process.
template <class ConcurrencyTag, class Range, class NT, class Callback, class NamedParameters>
bool search_distributed_range(const Communicator& comm, Range& range,
                              const Distance_bound<NT>& bound, Callback& callback,
                              Distributed_profile& profile, const NamedParameters& np)
{
  if constexpr(check_pair_search<ConcurrencyTag, Range, Range, Callback, NamedParameters>())
    return with_distributed_range(comm, range, np, [&](const auto& elements, const auto& sets) {
      return report_distributed_pairs<ConcurrencyTag>(comm, elements, sets, bound, callback,
                                                      profile, np);
    });
  else
    return false;
}

// Searches two ranges on each process.
template <class ConcurrencyTag, class RangeA, class RangeB, class NT, class Callback,
          class NamedParameters>
bool search_distributed_ranges(const Communicator& comm, RangeA& range_a, RangeB& range_b,
                               const Distance_bound<NT>& bound, Callback& callback,
                               Distributed_profile& profile, const NamedParameters& np)
{
  if constexpr(check_pair_search<ConcurrencyTag, RangeA, RangeB, Callback, NamedParameters>()) {
    const auto search = [&](const auto& elements, const auto& sets) {
      return report_distributed_pairs<ConcurrencyTag>(comm, elements, sets, bound, callback,
                                                      profile, np);
    };
    return with_distributed_ranges(comm, range_a, range_b, np, search);
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_DISTRIBUTED_PAIRS_SEARCH_H
