// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_POINT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_POINT_H

// A point on its way through the slabs.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <array>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The coordinates of a point along the axes that are searched, as doubles or as 32-bit integers,
// and its position. What only threads need that share slabs is not compiled unless they may.
template <int Dimension, class CoordinateNumber, bool MayBeShared = true>
struct Slab_point
{
  using Number = CoordinateNumber;
  static constexpr bool may_be_shared = MayBeShared;
  static constexpr int dimension = Dimension;
  static constexpr int slab_axis = Dimension - 1; // the axis that slabs are cut along

  using Run = internal::Run<Dimension, Number>;

  std::array<Number, Dimension> x;
  Place position;
};

// Which points meet each other. If they are two sets, the first one has the positions below its
// size, and only points of different sets meet. One set may be a column of slabs with its border
// (Slab_column.h): points of the border do not meet each other. They have a bit more in their
// positions.
struct Point_sets
{
  Place first_size = max_place; // of all points, if they are one set
  bool have_border = false; // only of points that may be shared

  static constexpr Place border_bit = Place(1) << 31;
  static constexpr Place side_of_border = 4;

  bool are_two() const { return first_size != max_place; }
  Place count() const { return are_two() || have_border ? 2 : 1; }
};

// The intervals of the coordinates of some points, one per axis.
template <int Dimension>
using Box_of_intervals = std::array<Interval, Dimension>;

template <class Point>
Box_of_intervals<Point::dimension> box_of(const Point* first, const Point* last)
{
  Box_of_intervals<Point::dimension> box;
  for(; first != last; ++first)
    for(int axis = 0; axis < Point::dimension; ++axis)
      box[axis].add(first->x[axis]);
  return box;
}

// Numbers for the points of slabs that become ready. Searches of pairs need none, and do not
// compile what gives them.
class Place_numbers
{
public:
  // Returns the first of `size` consecutive numbers for a slab behind those in the window. Sets
  // `positions` to where to write the positions of its points, by their numbers from there on.
  virtual Place add(Place size, Place*& positions) = 0;

protected:
  ~Place_numbers() = default;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_POINT_H
