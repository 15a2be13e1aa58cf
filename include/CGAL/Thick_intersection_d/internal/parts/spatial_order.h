// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_SPATIAL_ORDER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_SPATIAL_ORDER_H

// Puts the points of a part in an order in which near points are near in memory.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Cells of a box with about four points each, if the points are everywhere in it. They follow each
// other as slabs, strips and buckets do: the last axes of the box count, three at most.
class Cell_order
{
public:
  Cell_order(const Part_box& box, std::size_t point_count)
  {
    const std::vector<Interval>& intervals = box.intervals();
    const std::size_t axes_count = (std::min)(intervals.size(), std::size_t(3));
    const double cells = (std::min)(static_cast<double>(point_count) / 4, 1. * max_size);
    side_ = std::floor((std::max)(1., std::pow(cells, 1. / static_cast<double>(axes_count))));
    for(std::size_t i = 0; i < axes_count; ++i) {
      const std::size_t axis = intervals.size() - 1 - i;
      const double length = intervals[axis].length();
      axes_.push_back({axis, intervals[axis].low, length > 0 ? side_ / length : 0});
      size_ *= static_cast<std::size_t>(side_);
    }
  }

  std::size_t size() const { return size_; }

  template <class Coordinates>
  std::size_t operator()(const Coordinates& x) const
  {
    std::size_t number = 0;
    for(const Axis& axis : axes_) {
      const double cell = (x[axis.number] - axis.low) * axis.scale;
      number = number * static_cast<std::size_t>(side_)
               + (cell > 0 ? static_cast<std::size_t>((std::min)(cell, side_ - 1)) : 0);
    }
    return number;
  }

private:
  static constexpr std::size_t max_size = std::size_t(1) << 21;

  struct Axis
  {
    std::size_t number;
    double low;
    double scale; // zero if the box has no length or an infinite one
  };

  std::vector<Axis> axes_;
  std::size_t size_ = 1;
  double side_ = 1; // an integer
};

// Moves each value to its place. Some room behind them stays, for points that are near.
template <class Value>
void move_to_places(std::vector<Value>& values, const std::vector<std::uint32_t>& places)
{
  std::vector<Value> moved;
  reserve_huge_pages(moved, (std::min)(values.capacity(), values.size() + values.size() / 8));
  moved.resize(values.size());
  for(std::size_t i = 0; i < values.size(); ++i)
    moved[places[i]] = std::move(values[i]);
  values = std::move(moved);
}

// A search reports pairs of positions slab by slab, strip by strip and bucket by bucket. Ids in
// this order are found in the cache. A part has fewer than 2^32 points, or its search refuses them.
template <class Carried>
void sort_by_cells(Part_points<Carried>& part, int dimension)
{
  if(part.size() == 0)
    return;
  Part_box box(dimension);
  for(const Carried& point : part.points)
    box.add(point);
  const Cell_order cells(box, part.size());
  std::vector<std::uint32_t> begins(cells.size() + 1);
  auto places = zeros_on_huge_pages<std::uint32_t>(part.size());
  for(std::size_t i = 0; i < part.size(); ++i) {
    places[i] = static_cast<std::uint32_t>(cells(part.points[i]));
    ++begins[places[i] + 1];
  }
  for(std::size_t cell = 0; cell < cells.size(); ++cell)
    begins[cell + 1] += begins[cell];
  for(std::uint32_t& place : places)
    place = begins[place]++;
  move_to_places(part.points, places);
  move_to_places(part.ids, places);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_SPATIAL_ORDER_H
