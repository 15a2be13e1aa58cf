// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_SPATIAL_ORDER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_SPATIAL_ORDER_H

// Puts the points of a part in an order in which near points are near in memory.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Rows of cells across the last two axes of a box, as slabs and strips are.
class Cell_rows
{
public:
  explicit Cell_rows(const Part_box& box)
  {
    const std::vector<Interval>& intervals = box.intervals();
    for(std::size_t i = 0; i < axes_count; ++i) {
      axes_[i] = intervals.size() > i ? intervals.size() - 1 - i : 0;
      low_[i] = intervals[axes_[i]].low;
      const double length = intervals[axes_[i]].length();
      scale_[i] = length > 0 ? side / length : 0; // zero if the length is infinite
    }
  }

  static constexpr std::size_t size() { return std::size_t(side) * side; }

  template <class Coordinates>
  std::size_t operator()(const Coordinates& x) const
  {
    std::size_t row = 0;
    for(std::size_t i = 0; i < axes_count; ++i) {
      const double cell = (x[axes_[i]] - low_[i]) * scale_[i];
      row = row * side + (cell > 0 ? static_cast<std::size_t>((std::min)(cell, side - 1.)) : 0);
    }
    return row;
  }

private:
  static constexpr int side = 64;
  static constexpr std::size_t axes_count = 2;

  std::size_t axes_[axes_count];
  double low_[axes_count];
  double scale_[axes_count];
};

// Moves each value to its place.
template <class Value>
void move_to_places(std::vector<Value>& values, const std::vector<std::uint32_t>& places)
{
  std::vector<Value> moved(values.size());
  for(std::size_t i = 0; i < values.size(); ++i)
    moved[places[i]] = std::move(values[i]);
  values = std::move(moved);
}

// A search reports pairs of positions slab by slab and strip by strip. Ids that are in this order
// as well are found in the cache. A part has fewer than 2^32 points, or its search refuses them.
template <class Carried>
void sort_by_rows(Part_points<Carried>& part, int dimension)
{
  if(part.size() == 0)
    return;
  Part_box box(dimension);
  for(const Carried& point : part.points)
    box.add([&](int axis) { return point.bounds_along(axis); });
  const Cell_rows rows(box);
  std::vector<std::size_t> begins(rows.size() + 1);
  std::vector<std::uint32_t> places(part.size());
  for(std::size_t i = 0; i < part.size(); ++i) {
    places[i] = static_cast<std::uint32_t>(rows(part.lower_bounds(i)));
    ++begins[places[i] + 1];
  }
  for(std::size_t row = 0; row < rows.size(); ++row)
    begins[row + 1] += begins[row];
  for(std::uint32_t& place : places)
    place = static_cast<std::uint32_t>(begins[place]++);
  move_to_places(part.points, places);
  move_to_places(part.ids, places);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_SPATIAL_ORDER_H
