// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_COLUMNS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_COLUMNS_H

// Cuts slabs into columns of equal width, along the axis before that of slabs. So threads share
// slabs that are too few for them.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Slab_columns
{
public:
  Slab_columns() = default; // one column

  // At most `count` columns of an interval, or one, if columns could not be much wider than the
  // reach.
  Slab_columns(const Interval& interval, double reach, double count)
  {
    const double widest = interval.length() / (min_column_width * reach);
    if(!std::isfinite(interval.length()) || !(widest >= 2))
      return;
    const Slab_columns columns(interval, Equal_cut(interval, (std::min)(widest, count)));
    if(columns.are_wider_than(reach))
      *this = columns;
  }

  Place count() const { return cut_.count(); }

  // Returns the column of a coordinate.
  Place operator()(double x) const { return cut_(x); }

  // Returns a number above the coordinates in a column, which is not the last one, and a number
  // below those in a column, which is not the first one. The number of the column does not descend
  // with the coordinate, so a number of the next column is above all of this one.
  double above(Place column) const
  {
    double x = border(column + 1.);
    for(double step = first_step(); cut_(x) <= column; step *= 2)
      x += step;
    return x;
  }
  double below(Place column) const
  {
    double x = border(column);
    for(double step = first_step(); cut_(x) >= column; step *= 2)
      x -= step;
    return x;
  }

private:
  Slab_columns(const Interval& interval, const Equal_cut& cut) : interval_(interval), cut_(cut) {}

  // Whether only columns that follow each other are within reach.
  bool are_wider_than(double reach) const
  {
    for(Place column = 0; column + 1 < count(); ++column)
      if(cut_(above(column) + reach) > column + 1
         || cut_(below(column + 1) - reach) < column)
        return false;
    return true;
  }

  double border(double columns) const
  {
    return interval_.low + interval_.length() * (columns / count());
  }

  double first_step() const
  {
    return interval_.length() * 0x1p-20 + std::numeric_limits<double>::denorm_min();
  }

  Interval interval_ = {0, 0};
  Equal_cut cut_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SLAB_COLUMNS_H
