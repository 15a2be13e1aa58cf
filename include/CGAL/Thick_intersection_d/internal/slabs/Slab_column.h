// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_COLUMN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_COLUMN_H

// The slabs of one column, with the border of the column: points of the columns beside it that are
// within reach. A pair of two columns is reported in the lower one, so that needs the border above
// only. Lists of neighbors need both.
//
// Of points that are reported by other numbers than their positions, there are no columns: no bit
// of the numbers is free.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Slab_column
{
public:
  Slab_column(const Slabs<Point>& slabs, Place column, double reach,
              bool has_border_below)
    : slabs_(slabs), first_(column * slabs.count())
  {
    // Rounding is monotone, so it leaves no point within reach out, in any mode.
    if(column + 1 < slabs.columns().count())
      high_ = slabs.columns().above(column) + reach;
    if(has_border_below && column > 0)
      low_ = slabs.columns().below(column) - reach;
  }

  Point_sets sets() const { return slabs_.sets(); }
  Place count() const { return slabs_.count(); }

  // Returns the first of the points of a slab, and of its border, and sets their number.
  const Point* points(Place slab, Buffer<Point>& buffer, Place& number) const
  {
    if constexpr(Point::may_be_shared)
      if(slabs_.columns().count() > 1)
        return points_with_border(slab, buffer, number);
    return slabs_.points(slab, buffer, number);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int axis = Point::slab_axis - 1;

  BOOST_NOINLINE const Point* points_with_border(Place slab, Buffer<Point>& buffer,
                                                 Place& number) const
  {
    const Place own = first_ + slab;
    const Place above = own + count(), below = own - count();
    const Place size_above = high_ < infinity ? slabs_.size(above) : 0;
    const Place size_below = low_ > -infinity ? slabs_.size(below) : 0;
    Buffer<Point> none;
    const Point* const first = slabs_.points(own, none, number);
    Point* const points = buffer.require(number + size_above + size_below);
    std::copy_n(first, number, points);
    if(size_above != 0)
      number += copy_border(above, points + number, [&](double x) { return x <= high_; });
    if(size_below != 0)
      number += copy_border(below, points + number, [&](double x) { return x >= low_; });
    return points;
  }

  // Copies the points of a slab that are in the border. Returns how many they are.
  template <class Is_in_border>
  Place copy_border(Place slab, Point* border, const Is_in_border& is_in_border) const
  {
    Buffer<Point> none;
    Place size = 0;
    const Point* const first = slabs_.points(slab, none, size);
    Place count = 0;
    for(Place i = 0; i < size; ++i) {
      border[count] = first[i];
      border[count].position |= Point_sets::border_bit;
      count += is_in_border(first[i].x[axis]); // no branch: the next point takes the place
    }
    return count;
  }

  const Slabs<Point>& slabs_;
  const Place first_; // the first slab of the column
  double low_ = -infinity;
  double high_ = infinity;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_COLUMN_H
