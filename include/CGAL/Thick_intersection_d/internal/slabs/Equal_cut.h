// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_EQUAL_CUT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_EQUAL_CUT_H

// Cuts an interval into pieces of equal length.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Numbers the pieces by a monotone function of the coordinate, so that pieces follow each other
// along their axis. Nothing else is asked of its rounding: a sweep relies on the coordinates that
// pieces are found to have, not on those that they should have.
class Equal_cut
{
public:
  Equal_cut() = default; // one piece

  // Cuts an interval into `count` pieces; into one if that cannot be computed. Coordinates outside
  // belong to the first or to the last piece.
  Equal_cut(const Interval& interval, double count)
  {
    const double scale = std::floor(count) / interval.length();
    if(!(count >= 2) || !(scale > 0) || !std::isfinite(scale))
      return; // Case 1 of [V03]: not cut
    interval_ = interval;
    scale_ = scale;
    last_ = static_cast<Place>(count) - 1;
  }

  Place count() const { return last_ + 1; }

  // Compiled to minima and maxima: a branch would often be guessed wrong in pieces of few points.
  Place operator()(double x) const
  {
    const double inside = (std::min)((std::max)(x, interval_.low), interval_.high);
    const double piece = (inside - interval_.low) * scale_;
    return (std::min)(static_cast<Place>(static_cast<std::int64_t>(piece)), last_);
  }

private:
  Interval interval_ = {0, 0};
  double scale_ = 0;
  Place last_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_EQUAL_CUT_H
