// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_MUTUAL_NEIGHBORS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_MUTUAL_NEIGHBORS_H

// The lists of a search that was stopped. A pair may be missing in one of its two lists.

#include <CGAL/Neighbor_lists.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the lists with those pairs that are in both of their lists.
inline Neighbor_lists mutual_neighbors(const Neighbor_lists& lists)
{
  std::vector<std::size_t> begins(1, 0);
  std::vector<Neighbor_lists::Position> positions;
  for(std::size_t i = 0; i < lists.size(); ++i) {
    for(const Neighbor_lists::Position j : lists[i])
      if(std::binary_search(lists[j].begin(), lists[j].end(), i))
        positions.push_back(j);
    begins.push_back(positions.size());
  }
  return Neighbor_lists(std::move(begins), std::move(positions));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_MUTUAL_NEIGHBORS_H
