// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_GRID_STEPS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_GRID_STEPS_H

// A few doubles in steps of a grid of their own.
//
// Let 2^e Z be the coarsest grid that holds the differences of the doubles. They are few steps
// long, even if the doubles are far from zero, or near the ends of their range.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Differences of more bits are not computed.
constexpr int max_step_bits = 61;

// A double times a power of two, which itself may be beyond the doubles.
class Power_of_two
{
public:
  explicit Power_of_two(int exponent)
    : first_(power(exponent / 2)), second_(power(exponent - exponent / 2))
  {}

  double times(double x) const { return x * first_ * second_; }

private:
  static double power(int exponent)
  {
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    double result;
    std::memcpy(&result, &bits, sizeof(result));
    return result;
  }

  double first_;
  double second_;
};

// Returns an m such that |x| < 2^m, the least one if x is no denormal number.
inline int exponent_above(double x) { return static_cast<int>((bits_of(x) >> 52) & 0x7ff) - 1022; }

// Moves integers to an origin, and divides them by the largest power of two that leaves integers.
// Returns an m such that two of them differ by at most 2^m.
template <std::size_t N>
int coarsen(std::array<std::int64_t, N>& numbers)
{
  std::int64_t least = numbers[0], greatest = numbers[0];
  for(const std::int64_t x : numbers) {
    least = (std::min)(least, x);
    greatest = (std::max)(greatest, x);
  }
  std::uint64_t all_bits = std::uint64_t(1) << 62; // above all others
  for(std::int64_t& x : numbers) {
    x -= least;
    all_bits |= static_cast<std::uint64_t>(x);
  }
  const int zeros = logarithm(all_bits & (~all_bits + 1));
  for(std::int64_t& x : numbers)
    x >>= zeros;
  return (std::max)(exponent_above(static_cast<double>((greatest - least) >> zeros)), 0);
}

// Sets `steps` to the numbers in steps of a grid, from the least of them on. Returns an m such that
// two of them differ by at most 2^m steps, or more than max_step_bits if they do not fit.
//
// Let |x| < 2^m for all numbers. First they are counted in units of 2^(m - 60), or of the least
// double. Numbers that lose their lower bits do not fit. All others differ by less than 2^61 units.
// Products with powers of two are exact as long as no bit is lost, in every rounding mode.
template <std::size_t N>
int grid_steps(const std::array<double, N>& numbers, std::array<std::int64_t, N>& steps)
{
  double largest = 0;
  for(const double x : numbers)
    largest = (std::max)(largest, std::fabs(x));
  const int exponent = (std::max)(exponent_above(largest) - 60, -1074);
  const Power_of_two unit(exponent), units(-exponent);
  bool are_exact = true;
  for(std::size_t i = 0; i < N; ++i) {
    steps[i] = static_cast<std::int64_t>(units.times(numbers[i]));
    are_exact &= unit.times(static_cast<double>(steps[i])) == numbers[i];
  }
  return are_exact ? coarsen(steps) : max_step_bits + 1;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_GRID_STEPS_H
