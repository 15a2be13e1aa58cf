// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_INTERVAL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_INTERVAL_H

// The coordinates between two doubles.

#include <boost/config.hpp> // BOOST_NOINLINE

#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// An interval without coordinates is empty: its lower end is above its upper end.
struct Interval
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  double length() const { return high - low; }
  double half_length() const { return high / 2 - low / 2; } // of finite ends, does not overflow

  // Extends the interval until it holds x.
  void add(double x)
  {
    low = x < low ? x : low;
    high = high < x ? x : high;
  }

  // Extends the interval until it holds another interval.
  void add(const Interval& other)
  {
    low = other.low < low ? other.low : low;
    high = high < other.high ? other.high : high;
  }
};

inline bool do_meet(const Interval& a, const Interval& b)
{
  return a.low <= b.high && b.low <= a.high;
}

// Returns an interval that is longer by `reach`, or by a little more. In every rounding mode, the
// sum is off by less than a step of doubles, which is at most 2^-52 of it. Two steps are added, of
// which that rounding takes less than one. Sums that underflow are exact. A search asks for it in
// many places, once for each box, so it is not inline.
BOOST_NOINLINE inline Interval longer(const Interval& interval, double reach)
{
  const double high = interval.high + reach;
  return {interval.low, high + std::fabs(high) * 0x1p-51};
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_INTERVAL_H
