// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STRIPES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STRIPES_H

// Cuts numbers where a sample has equal shares of them.

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Finds the stripe of a number. Numbers in order have stripes in order.
class Stripes
{
public:
  // `values` are in order. Some of them are below a cut, and some are not, unless all are equal.
  // `count` is a power of two.
  Stripes(const std::vector<double>& values, std::size_t count)
    : cuts_(1, -std::numeric_limits<double>::infinity())
  {
    for(std::size_t stripe = 1; stripe < count; ++stripe)
      cuts_.push_back(values[stripe * values.size() / count]);
    if(cuts_.back() == values.front())
      cuts_.back() = values.back();
  }

  // Returns the last stripe that begins with x or a lesser number. There is no branch: it would be
  // mispredicted for half of the numbers.
  std::size_t operator()(double x) const
  {
    std::size_t stripe = 0;
    for(std::size_t step = cuts_.size() / 2; step > 0; step /= 2)
      stripe += step * (cuts_[stripe + step] <= x); // x is less than cuts_[stripe + 2 * step]
    return stripe;
  }

private:
  std::vector<double> cuts_; // where stripes begin
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STRIPES_H
