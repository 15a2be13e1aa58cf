// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_BALL_BOX_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_BALL_BOX_FILTER_H

// Decides about two balls by their boxes, unless it is a near tie. A sweep has the boxes at hand.
// The balls are anywhere in memory.

#include <CGAL/Uncertain.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/squared_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// For boxes of ball_interval(), along all axes, of balls whose numbers are doubles.
//
// The sum of the ends of a box is twice the center, and their difference is twice the radius. Let w
// be 2^-52, which bounds the error of an operation in every rounding mode, and M the largest
// absolute end. An end is off by at most 2wM, so a computed sum or difference of ends is off by at
// most 6wM, and the difference of two sums by 16wM. In up to eight dimensions, twice the distance
// of the centers is off by at most 46wM, and twice the sum of the radii by 16wM. The slack below is
// at least 128wM. The rest of it covers the rounding of radii +- slack, and underflow.
struct Ball_box_filter
{
  template <std::size_t Axes>
  static Uncertain<bool> do_intersect(const std::array<Interval, Axes>& a,
                                      const std::array<Interval, Axes>& b)
  {
    static_assert(Axes <= 8);
    const double radii = (a[0].high - a[0].low) + (b[0].high - b[0].low);
    double twice_largest_end = radii;
    double s = 0;
    for(std::size_t axis = 0; axis < Axes; ++axis) {
      const double center_of_a = a[axis].low + a[axis].high;
      const double center_of_b = b[axis].low + b[axis].high;
      twice_largest_end += std::fabs(center_of_a) + std::fabs(center_of_b);
      s += (center_of_a - center_of_b) * (center_of_a - center_of_b);
    }
    const double slack = 0x1p-46 * twice_largest_end;
    const double error = relative_error(Axes);
    const double least = radii - slack, most = radii + slack;
    if(!(slack * slack > min_safe_square && most * most < max_safe_square))
      return Uncertain<bool>::indeterminate();
    if(s > most * most * (1 + error))
      return false;
    if(least > 0 && s <= least * least * (1 - error))
      return true;
    return Uncertain<bool>::indeterminate();
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_BALL_BOX_FILTER_H
