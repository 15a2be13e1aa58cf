// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_EQUAL_CUT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_EQUAL_CUT_H

// Cuts an interval into pieces of equal length.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Numbers the pieces by a monotone function of the coordinate, so pieces follow each other along
// their axis. The function may round as it likes: a sweep compares the coordinates that the pieces
// really have, not the computed limits.
class Equal_cut
{
public:
  Equal_cut() = default; // one piece

  // Cuts an interval into `count` pieces, or into one piece if it cannot compute them: the ends are
  // to be finite, and to differ. Coordinates outside the interval belong to the first or the last
  // piece.
  Equal_cut(const Interval& interval, double count)
  {
    const double unit = unit_of(interval);
    const double low = interval.low * unit;
    const double scale = std::floor(count) / (interval.high * unit - low);
    if(!(count >= 2) || !(scale > 0) || !std::isfinite(scale))
      return; // not cut, as in case 1 of [V03]
    interval_ = interval;
    unit_ = unit;
    low_ = low;
    scale_ = scale;
    last_ = static_cast<Place>(count) - 1;
  }

  Place count() const { return last_ + 1; }

  // Compilers make minima and maxima of this. Among few points, the processor would often
  // mispredict a branch.
  Place operator()(double x) const
  {
    const double inside = (std::min)((std::max)(x, interval_.low), interval_.high);
    const double piece = (inside * unit_ - low_) * scale_;
    return (std::min)(static_cast<Place>(static_cast<std::int64_t>(piece)), last_);
  }

private:
  // Returns a power of two to multiply the coordinates by, so that neither their differences nor
  // the inverses of these overflow.
  static double unit_of(const Interval& interval)
  {
    const double length = interval.length();
    return length < 0x1p-900 ? 0x1p600 : length < 0x1p1020 ? 1 : 0x1p-4;
  }

  Interval interval_ = {0, 0};
  double unit_ = 1;
  double low_ = 0; // the lower end, in units
  double scale_ = 0;
  Place last_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_EQUAL_CUT_H
