// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_GRID_STEPS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_GRID_STEPS_H

// Differences of a few doubles, in steps of a grid of their own.
//
// Let 2^e Z be the coarsest grid that holds the doubles. Their differences are few steps long, even
// if they are small and far from zero, or near the ends of the range of doubles.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Differences of more bits are not computed.
constexpr int max_step_bits = 61;

// Returns the least m such that a rounded difference shows that the difference is at most 2^m.
//
// A rounded difference below 2^m is one of a difference of at most 2^m, because rounding is
// monotone and fixes 2^m. What overflows is infinite or the largest double, in the rounding mode.
// Both stand for a difference below 2^1025.
inline int bits_of_difference(double rounded)
{
  if(rounded == 0)
    return -1074;
  return rounded < (std::numeric_limits<double>::max)() ? std::ilogb(rounded) + 1 : 1025;
}

template <std::size_t N>
struct Grid_steps
{
  std::array<std::int64_t, N> steps; // if there are at most max_step_bits
  int bits;                          // each difference is at most 2^bits steps
};

// Returns the differences x[i] - x[0] for i > 0. If they have at most max_step_bits, they are those
// of the numbers of steps modulo 2^64.
template <std::size_t N>
Grid_steps<N - 1> grid_steps(const std::array<double, N>& x)
{
  Double_grid grid;
  double largest = 0;
  for(const double value : x) {
    grid.add(value);
    largest = (std::max)(largest, std::fabs(value - x[0]));
  }
  Grid_steps<N - 1> result = {};
  result.bits = (std::max)(bits_of_difference(largest) - grid.exponent(), 0);
  if(result.bits > max_step_bits)
    return result;
  const std::uint64_t origin = steps_modulo_2_64(x[0], grid.exponent());
  for(std::size_t i = 1; i < N; ++i)
    result.steps[i - 1]
      = static_cast<std::int64_t>(steps_modulo_2_64(x[i], grid.exponent()) - origin);
  return result;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_GRID_STEPS_H
