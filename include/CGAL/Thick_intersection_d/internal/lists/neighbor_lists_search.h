// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_LISTS_SEARCH_H

// The search behind fixed_radius_neighbor_lists().

#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/lists/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if there are too many points, of one range or two, for the positions in lists.
inline void check_list_size(std::size_t size)
{
  if(size > (std::numeric_limits<Neighbor_lists::Position>::max)())
    throw std::length_error("There are more points than lists of neighbors have positions for.");
}

// Replaces `lists`, in the memory that they have, by those of numbered elements. Of two sets, the
// lists have positions in the second one, for each element of the first. Reports of
// search(elements, sets, callback) are pairs of positions, and it returns false iff it was stopped.
// So does this function.
template <class Elements, class Sets, class Search>
bool collect_pairs(Neighbor_lists& lists, const Elements& elements, const Sets& sets,
                   const Search& search, const Threads& threads)
{
  check_list_size(elements.size());
  if constexpr(Sets::are_two) {
    Neighbor_collector collector(sets.first_size, threads);
    const Second_as_neighbor add(collector);
    const bool is_complete = search(elements, sets, add);
    lists = collector.lists(false, std::move(lists));
    return is_complete;
  }
  else {
    Neighbor_collector collector(elements.size(), threads);
    const bool is_complete = search(elements, sets, collector);
    lists = collector.lists(true, std::move(lists));
    if(!is_complete)
      lists = mutual_neighbors(lists);
    return is_complete;
  }
}

// The same of the elements of one range or of two.
template <class NamedParameters, class Search, class... Ranges>
bool collect_lists(Neighbor_lists& lists, const NamedParameters& np, const Threads& threads,
                   const Search& search, Ranges&... ranges)
{
  if constexpr((check_range<Ranges, NamedParameters>() && ...)) {
    const auto collect = [&](const auto& elements, const auto& sets) {
      return collect_pairs(lists, elements, sets, search, threads);
    };
    return with_sets(collect, make_elements(ranges, np)...);
  }
  else
    return false;
}

// The same of near points.
template <class NT, class NamedParameters, class... Ranges>
bool collect_neighbors(Neighbor_lists& lists, const Distance_bound<NT>& bound,
                       const NamedParameters& np, const Threads& threads, Ranges&... ranges)
{
  return collect_lists(lists, np, threads, near_search(bound, np, threads), ranges...);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_LISTS_SEARCH_H
