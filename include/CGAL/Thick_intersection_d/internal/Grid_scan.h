// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_GRID_SCAN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_GRID_SCAN_H

// The coarsest grid 2^e Z that holds a sequence of doubles.

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Grid_scan
{
public:
  // Refines the grid until it holds the finite number x.
  void add(double x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t(1) << 52) - 1);

    // |x| = mantissa * 2^exponent
    const std::uint64_t mantissa = biased == 0 ? fraction : fraction | (std::uint64_t(1) << 52);
    const int exponent = (biased == 0 ? 1 : biased) - 1075;
    if(mantissa != 0 && !is_multiple(mantissa, exponent))
      exponent_ = lowest_bit(mantissa, exponent);
  }

  // Refines the grid until it holds all that the other one holds.
  void add(const Grid_scan& other) { exponent_ = (std::min)(exponent_, other.exponent_); }

  // Returns e, or 0 if no number but zero was added.
  int exponent() const { return exponent_ == none ? 0 : exponent_; }

private:
  bool is_multiple(std::uint64_t mantissa, int exponent) const
  {
    const int zeros_needed = exponent_ - exponent;
    return zeros_needed <= 0
           || (zeros_needed < 53 && (mantissa & ((std::uint64_t(1) << zeros_needed) - 1)) == 0);
  }

  static int lowest_bit(std::uint64_t mantissa, int exponent)
  {
    for(; (mantissa & 1) == 0; mantissa >>= 1)
      ++exponent;
    return exponent;
  }

  static constexpr int none = 2000; // above every exponent of a double
  int exponent_ = none;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_GRID_SCAN_H
