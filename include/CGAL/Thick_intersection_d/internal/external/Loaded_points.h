// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H

// A part in memory.

#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/spatial_order.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The points of a part, in the order in which a search sweeps them, roughly: it looks up the id of
// both points of each pair. In the order of the input, these ids are all over the memory, and
// looking them up takes longer than the search.
template <class Point>
struct Loaded_points
{
  std::vector<Point> points;
  std::vector<std::uint64_t> ids;
  std::size_t owned = 0; // the first ones; pairs of the others are found elsewhere

  // The first `owned_count` points are the part's own, with their box.
  Loaded_points(const std::vector<Stored_point>& stored, std::size_t owned_count,
                const Part_box& box)
    : points(stored.size()), ids(stored.size()), owned(owned_count)
  {
    const Cell_rows rows(box);
    std::vector<std::size_t> places(Cell_rows::size() + 1);
    for(std::size_t i = 0; i < owned; ++i)
      ++places[rows(stored[i].x) + 1];
    for(std::size_t cell = 0; cell < Cell_rows::size(); ++cell)
      places[cell + 1] += places[cell];
    for(std::size_t i = 0; i < owned; ++i)
      put(stored[i], places[rows(stored[i].x)]++);
    for(std::size_t i = owned; i < stored.size(); ++i)
      put(stored[i], i);
  }

private:
  void put(const Stored_point& point, std::size_t place)
  {
    points[place] = Point(point.x[0], point.x[1], point.x[2]);
    ids[place] = point.id;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
