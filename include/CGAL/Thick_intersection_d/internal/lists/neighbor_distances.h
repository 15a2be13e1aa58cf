// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_DISTANCES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_DISTANCES_H

// The distances behind neighbor_squared_distances().

#include <CGAL/Neighbor_lists.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// In the number type of the coordinates, whether or not it rounds: users compare the result with
// what their kernel computes.
template <class Point>
Coordinate_t<Point> squared_distance_of(const Point& p, const Point& q)
{
  using FT = Coordinate_t<Point>;
  FT sum(0);
  const int dimension = dimension_of(p);
  for(int axis = 0; axis < dimension; ++axis) {
    const FT difference(coordinate(p, axis) - coordinate(q, axis));
    sum += difference * difference;
  }
  return sum;
}

// Throws unless the lists can be those of so many points, with neighbors among so many others.
inline void check_lists(const Neighbor_lists& lists, std::size_t size, std::size_t other_size)
{
  if(lists.size() != size)
    throw std::invalid_argument("There are " + std::to_string(lists.size())
                                + " lists of neighbors for " + std::to_string(size) + " points.");
  for(const Neighbor_lists::Position position : lists.positions())
    if(position >= other_size)
      throw std::invalid_argument("The lists have a neighbor at position "
                                  + std::to_string(position) + ", but there are only "
                                  + std::to_string(other_size) + " points.");
}

template <class Points, class Others>
auto squared_distances_in_lists(const Neighbor_lists& lists, const Points& points,
                                const Others& others)
{
  check_lists(lists, points.size(), others.size());
  std::vector<Coordinate_t<typename Points::value_type>> distances;
  distances.reserve(lists.positions().size());
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto& point = points[i];
    for(const Neighbor_lists::Position j : lists[i])
      distances.push_back(squared_distance_of(point, others[j]));
  }
  return distances;
}

// Of two ranges, the lists are those of the points of the first one.
template <class NamedParameters, class... Ranges>
auto compute_neighbor_distances(const Neighbor_lists& lists, const NamedParameters& np,
                                Ranges&... ranges)
{
  if constexpr((check_range_of_points<Ranges, NamedParameters>() && ...)) {
    const std::tuple all(make_elements(ranges, np)...);
    return squared_distances_in_lists(lists, std::get<0>(all),
                                      std::get<sizeof...(Ranges) - 1>(all));
  }
  else
    return std::vector<double>();
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LISTS_NEIGHBOR_DISTANCES_H
