// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_INTERVAL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARRAYS_INTERVAL_H

// The coordinates between two doubles.

#include <boost/config.hpp> // BOOST_NOINLINE

#include <cmath>
#include <cstdint>
#include <cstring>
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

// Returns the largest double below x, or x itself if it is minus infinity or NaN. std::nextafter()
// does the same in a call, which takes longer than all else that is done to an interval.
inline double double_before(double x)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(!(std::fabs(x) > 0) || x == -infinity)
    return x == 0 ? -std::numeric_limits<double>::denorm_min() : x;
  std::int64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  bits += x > 0 ? -1 : 1;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// Returns the smallest double above x, or x itself if it is infinity or NaN.
inline double double_after(double x) { return -double_before(-x); }

// Returns the closed interval of the doubles in a half-open one, which ends in the last double that
// it contains: x < y iff x is at most the double before y. This holds for zeros of both signs,
// denormal numbers and infinity.
inline Interval half_open(const Interval& interval)
{
  return {interval.low, double_before(interval.high)};
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
