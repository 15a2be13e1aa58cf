// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DOUBLE_GRID_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DOUBLE_GRID_H

// The coarsest grid 2^e Z that holds a sequence of doubles, and doubles in steps of a grid.

#include <algorithm>
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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DOUBLE_GRID_H
