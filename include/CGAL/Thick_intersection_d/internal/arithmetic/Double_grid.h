// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DOUBLE_GRID_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DOUBLE_GRID_H

// The coarsest grid 2^e Z that holds a sequence of doubles, and doubles in steps of a grid.

#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

inline std::uint64_t bits_of(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

// A finite double taken apart: |x| = mantissa * 2^exponent.
struct Double_parts
{
  explicit Double_parts(double x)
  {
    const std::uint64_t bits = bits_of(x);
    const std::uint64_t fraction = bits & ((std::uint64_t(1) << 52) - 1);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    mantissa = fraction | static_cast<std::uint64_t>(biased != 0) << 52;
    exponent = (std::max)(biased, 1) - 1075;
  }

  std::uint64_t mantissa;
  int exponent;
};

// Returns x / 2^e modulo 2^64, if x is a multiple of 2^e. Otherwise drops the bits below 2^e, so
// equal numbers have equal results.
inline std::uint64_t steps_modulo_2_64(double x, int e)
{
  const Double_parts parts(x);
  const int shift = parts.exponent - e;
  const std::uint64_t steps = shift >= 64 || shift <= -64 ? 0
                              : shift >= 0                ? parts.mantissa << shift
                                                          : parts.mantissa >> -shift;
  return x < 0 ? 0 - steps : steps;
}

// Returns the exponent of a power of two below 2^63, read from the bits of a double.
inline int logarithm(std::uint64_t power)
{
  return static_cast<int>(bits_of(static_cast<double>(static_cast<std::int64_t>(power))) >> 52)
         - 1023;
}

class Double_grid
{
public:
  Double_grid() = default; // the coarsest of all
  explicit Double_grid(int exponent) : exponent_(exponent) {}

  // Refines the grid until it holds the finite number x. The last bit of most numbers, whatever it
  // is, is on the grid of the numbers before. The number of zeros at the end of a mantissa cannot
  // be predicted, so it takes no branch.
  void add(double x)
  {
    const Double_parts parts(x);
    if(parts.exponent >= exponent_ || parts.mantissa == 0)
      return;
    const std::uint64_t lowest_bit = parts.mantissa & (~parts.mantissa + 1);
    exponent_ = (std::min)(exponent_, parts.exponent + logarithm(lowest_bit));
  }

  // Refines the grid until it holds all numbers of another grid.
  void add(const Double_grid& other) { exponent_ = (std::min)(exponent_, other.exponent_); }

  bool holds(double x) const
  {
    Double_grid refined = *this;
    refined.add(x);
    return refined.exponent_ == exponent_;
  }

  // Returns e, or 0 if no number but zero was added.
  int exponent() const { return exponent_ == none ? 0 : exponent_; }

private:
  static constexpr int none = 2000; // above every exponent of a double
  int exponent_ = none;
};

// A few doubles in steps of a grid of their own.
//
// Let 2^e Z be the coarsest grid that holds the differences of the doubles. They are few steps
// long, even if the doubles are far from zero, or near the ends of their range.

// Differences of more bits are not computed.
constexpr int max_step_bits = 61;

// For exponents from -1022 to 1023.
inline double power_of_two(int exponent)
{
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  double result;
  std::memcpy(&result, &bits, sizeof(result));
  return result;
}

// Returns an m such that |x| < 2^m, the least one if x is no denormal number.
inline int exponent_above(double x) { return static_cast<int>((bits_of(x) >> 52) & 0x7ff) - 1022; }

template <std::size_t N>
int grid_steps(const std::array<double, N>& numbers, std::array<std::int64_t, N>& steps);

// Below this the powers of two that scale numbers are no normal doubles.
constexpr double least_scalable = 0x1p-962;

// Scales numbers up to where grid_steps() can scale them, unless all are zero.
template <std::size_t N>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
int grid_steps_of_tiny(std::array<double, N> numbers, double largest,
                                          std::array<std::int64_t, N>& steps)
{
  for(double& x : numbers)
    x *= 0x1p200;
  steps = {};
  return largest == 0 ? 0 : grid_steps(numbers, steps);
}

// Sets `steps` to the numbers in steps of a grid, from the least of them on. Returns an m such that
// two of them differ by at most 2^m steps, or more than max_step_bits if they do not fit.
//
// Let |x| < 2^m for all numbers. First they are counted in units of 2^(m - 60). Numbers that lose
// their lower bits do not fit. All others differ by less than 2^61 units. Products with powers of
// two are exact as long as no bit is lost, in every rounding mode.
template <std::size_t N>
int grid_steps(const std::array<double, N>& numbers, std::array<std::int64_t, N>& steps)
{
  double least = numbers[0], greatest = numbers[0];
  for(const double x : numbers) {
    least = (std::min)(least, x);
    greatest = (std::max)(greatest, x);
  }
  const double largest = (std::max)(-least, greatest);
  if(largest < least_scalable)
    return grid_steps_of_tiny(numbers, largest, steps);
  const int exponent = exponent_above(largest) - 60;
  const double unit = power_of_two(exponent), units = power_of_two(-exponent);
  const auto to_units = [&](double x) { return static_cast<std::int64_t>(x * units); };
  const std::int64_t origin = to_units(least);
  double lost = 0;
  std::uint64_t all_bits = std::uint64_t(1) << 62; // above all others
  for(std::size_t i = 0; i < N; ++i) {
    const std::int64_t x = to_units(numbers[i]);
    lost += std::fabs(static_cast<double>(x) * unit - numbers[i]);
    steps[i] = x - origin;
    all_bits |= static_cast<std::uint64_t>(steps[i]);
  }
  if(lost != 0)
    return max_step_bits + 1;
  const int zeros = logarithm(all_bits & (~all_bits + 1));
  for(std::int64_t& x : steps)
    x = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) >> zeros);
  const std::int64_t width = (to_units(greatest) - origin) >> zeros;
  return (std::max)(exponent_above(static_cast<double>(width)), 0);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DOUBLE_GRID_H
