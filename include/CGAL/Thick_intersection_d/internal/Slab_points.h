// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_POINTS_H

// Points as the slab route sees them: a column of doubles per axis, and the positions of the points
// in the user's range. A place is an index into the columns, which are reordered together.

#include <CGAL/Thick_intersection_d/internal/coordinates.h>

#include <array>
#include <cstdint>
#include <memory>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

using Place = std::uint32_t;

// Memory that is written before it is read: not cleared first.
template <class T>
std::unique_ptr<T[]> make_uninitialized(std::size_t size)
{
  return std::unique_ptr<T[]>(new T[size]);
}

template <int Dimension>
class Slab_points
{
public:
  // The points at the positions [first, last).
  template <class Elements>
  Slab_points(const Elements& points, std::size_t first, std::size_t last)
    : positions(make_uninitialized<Place>(last - first)), size_(static_cast<Place>(last - first))
  {
    for(auto& column : columns) {
      column = make_uninitialized<double>(size_ + std::size_t(1));
      column[size_] = 0; // a sweep may look at one place behind the last
    }
    for(Place i = 0; i < size_; ++i) {
      load(points[first + i], i);
      positions[i] = static_cast<Place>(first + i);
    }
  }

  Place size() const { return size_; }

  // Coordinates are not less than their doubles, and not greater by more than this.
  double error() const { return error_; }

  std::array<std::unique_ptr<double[]>, Dimension> columns;
  std::unique_ptr<Place[]> positions;

private:
  template <class Point>
  void load(const Point& p, Place i)
  {
    for(int axis = 0; axis < Dimension; ++axis) {
      const std::pair<double, double> x = bounds(coordinate(p, axis));
      columns[axis][i] = x.first;
      if constexpr(!is_held_by_double_v<Coordinate_t<Point>>)
        error_ = (std::max)(error_, x.second - x.first);
    }
  }

  Place size_;
  double error_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_POINTS_H
