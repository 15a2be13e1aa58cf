// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_SQUARED_SUMS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_SQUARED_SUMS_H

// Bounds the error of a sum of squares that doubles compute.

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_SQUARED_SUMS_H
