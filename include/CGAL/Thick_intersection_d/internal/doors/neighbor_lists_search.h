// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEIGHBOR_LISTS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEIGHBOR_LISTS_SEARCH_H

// The search behind fixed_radius_neighbor_lists().

#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/doors/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/reports/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/reports/mutual_neighbors.h>
#include <CGAL/Thick_intersection_d/internal/reports/sets.h>

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if there are too many points, of one range or two, for the positions in lists.
inline void check_list_size(std::size_t size)
{
  if(size > (std::numeric_limits<Neighbor_lists::Position>::max)())
    throw std::length_error("There are more points than lists of neighbors have positions for.");
}

template <class ConcurrencyTag, class Range, class NT, class NamedParameters>
Neighbor_lists collect_neighbors(Range& range, const Distance_bound<NT>& bound,
                                 const NamedParameters& np)
{
  if constexpr(check_range<ConcurrencyTag, Range, NamedParameters>()) {
    const auto points = make_elements(range, np);
    check_list_size(points.size());
    Neighbor_collector<ConcurrencyTag> collector(points.size());
    if(!report_near_pairs<ConcurrencyTag>(points, One_set(), bound, collector, np))
      return mutual_neighbors(collector.lists());
    return collector.lists();
  }
  else
    return Neighbor_lists();
}

// The lists have positions in the second range, for each point of the first.
template <class ConcurrencyTag, class RangeA, class RangeB, class NT, class NamedParameters>
Neighbor_lists collect_neighbors(RangeA& range_a, RangeB& range_b, const Distance_bound<NT>& bound,
                                 const NamedParameters& np)
{
  if constexpr(!check_range<ConcurrencyTag, RangeA, NamedParameters>())
    return Neighbor_lists();
  else if constexpr(!check_range<ConcurrencyTag, RangeB, NamedParameters>())
    return Neighbor_lists();
  else
    return with_two_ranges(range_a, range_b, np, [&](const auto& points, std::size_t size_a) {
      check_list_size(points.size());
      Neighbor_collector<ConcurrencyTag> collector(size_a);
      const auto add = [&](std::size_t i, std::size_t j) { collector.add(i, j); };
      report_near_pairs<ConcurrencyTag>(points, Two_sets{size_a}, bound, add, np);
      return collector.lists(false);
    });
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEIGHBOR_LISTS_SEARCH_H
