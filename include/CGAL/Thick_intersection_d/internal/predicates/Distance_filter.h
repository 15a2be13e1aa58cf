// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DISTANCE_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DISTANCE_FILTER_H

// A filter in doubles. It decides whether a squared distance s is within a squared bound:
//
//   s <= inside   the distance is certainly within the bound
//   s > outside   the distance is certainly beyond the bound
//   else          undecided
//
// The error of a sum of squares of differences is relative, because nothing cancels after the
// subtractions. So the two constants depend on the bound alone, not on the points.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Bounds the error of a sum of squares that doubles compute.

// Squares below the first constant lose bits to underflow: at most d 2^-1022 in a sum of d squares.
// If a computed sum is above the second constant, the true sum is above the first.
inline constexpr double min_safe_square = 0x1p-960;
inline constexpr double min_safe_threshold = 0x1p-950;

// Sums of squares beyond this constant may overflow.
inline constexpr double max_safe_square = 0x1p1020;

// Returns a bound c on the relative error of the computed squared distance of two points. It covers
// the comparison with a rounded threshold as well. It holds in every rounding mode, with and
// without fused multiplication.
//
// Let u be 2^-53 for rounding to nearest and 2^-52 for the directed modes. Each difference has the
// relative error u, and its square 2u + u. At most d-1 additions of non-negative terms have (d-1)u.
// The threshold and its product with 1 -+ c have 3u. Together this is (d+5)u to first order, and
// 2^-49 for d <= 3 in the worst case.
inline double relative_error(int dimension)
{
  return std::ldexp((std::max)(dimension, 3) + 5, -52);
}

struct Distance_filter
{
  double inside = -1;
  double outside = std::numeric_limits<double>::infinity();
};

// Returns the filter for a squared bound between `low` and `high`, and points of any coordinates.
//
// Underflow: for a bound below min_safe_square the filter never says "inside", and it says
// "outside" only above min_safe_threshold. Overflow: for a bound above max_safe_square the filter
// never says "outside", because the sum of a distance within the bound may be infinite. It says
// "inside" only for sums of at most half of max_safe_square.
inline Distance_filter make_distance_filter(double low, double high, int dimension)
{
  Distance_filter filter;
  const double error = relative_error(dimension);
  if(low >= min_safe_square)
    filter.inside = (std::min)(low * (1 - error), max_safe_square / 2);
  if(high <= max_safe_square)
    filter.outside = (std::max)(high * (1 + error), min_safe_threshold);
  return filter;
}

template <class Exact>
Distance_filter make_distance_filter(const Squared_bound<Exact>& bound, int dimension)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(bound.is_unbounded())
    return {infinity, infinity};
  return make_distance_filter(bound.squared().first, bound.squared().second, dimension);
}

// Returns the filter for scenes where doubles compute all squared distances up to the bound without
// error. It decides every pair: s is exact, so s <= r^2 is equivalent to s <= T, where T is r^2
// rounded down.
template <class Exact>
Distance_filter make_certified_filter(const Squared_bound<Exact>& bound)
{
  const double threshold = bound.largest_double();
  return {threshold, threshold};
}

// Returns `filter`, widened for doubles that differ from the coordinates by up to `error`, in up to
// three dimensions. The distances of such doubles are off by less than twice the error.
template <class Exact>
Distance_filter widen(const Distance_filter& filter, const Squared_bound<Exact>& bound,
                      double error)
{
  if(error == 0 || bound.is_unbounded())
    return filter;
  const double slack = 4 * relative_error(3);
  const double low = std::sqrt(bound.squared().first) * (1 - slack) - 2 * error;
  const double high = (bound.reach() + 2 * error) * (1 + slack);
  Distance_filter wide;
  if(filter.inside > 0 && low > 0 && low * low > min_safe_square)
    wide.inside = (std::min)(filter.inside, low * low);
  wide.outside = (std::max)(filter.outside, high * high);
  return wide;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DISTANCE_FILTER_H
