// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DISTANCE_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DISTANCE_FILTER_H

// Decides |pq|^2 <= r^2 from a sum s of squares in doubles, by two constants:
//
//   s <= inside   the distance is certainly within the bound
//   s > outside   it is certainly not
//   else          undecided: the exact numbers decide
//
// A sum of squares of differences has a relative error only, since nothing cancels after the
// subtractions. So the constants depend on the bound alone, not on the points.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Distance_filter
{
  double inside = -1;
  double outside = std::numeric_limits<double>::infinity();
};

// A bound c on the relative error of s and on that of comparing it with a rounded threshold, in any
// rounding mode, with or without fused multiplication.
//
// With u = 2^-53 for rounding to nearest and 2^-52 for the directed modes: each difference has the
// relative error u, its square 2u + u, and the at most d-1 additions of non-negative terms (d-1)u;
// the threshold and its product with 1 -+ c have 3u. Together (d+5)u to first order, and 2^-49 for
// d <= 3, the worst case.
inline double relative_error(int dimension)
{
  return std::ldexp((std::max)(dimension, 3) + 5, -52);
}

// Returns the filter for points of any coordinates.
//
// Below 2^-960 squares lose bits to underflow, of at most d 2^-1022 in all: then the filter says
// "inside" never, and "outside" only above 2^-950. Above 2^1020 sums may overflow: then it says
// "outside" never, for an infinite sum may come from a distance within the bound, and "inside" for
// sums below 2^1019. An unbounded distance lets all sums pass.
template <class Exact>
Distance_filter make_distance_filter(const Squared_bound<Exact>& bound, int dimension)
{
  static const double tiny = std::ldexp(1., -960);
  static const double above_tiny = std::ldexp(1., -950);
  static const double huge = std::ldexp(1., 1020);

  Distance_filter filter;
  const double error = relative_error(dimension);
  if(bound.is_unbounded())
    filter.inside = filter.outside;
  else if(bound.squared().first >= tiny)
    filter.inside = (std::min)(bound.squared().first * (1 - error), huge / 2);
  if(bound.squared().second <= huge)
    filter.outside = (std::max)(bound.squared().second * (1 + error), above_tiny);
  return filter;
}

// Returns the filter for scenes in which doubles evaluate all squared distances up to the bound
// without error. Then it decides every pair: with d2 exact, d2 <= r^2 is equivalent to d2 <= T,
// where T is r^2 rounded down.
template <class Exact>
Distance_filter make_certified_filter(const Squared_bound<Exact>& bound)
{
  const double threshold = bound.largest_double();
  return {threshold, threshold};
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DISTANCE_FILTER_H
