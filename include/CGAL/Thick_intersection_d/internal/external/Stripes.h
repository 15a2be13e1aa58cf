// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STRIPES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STRIPES_H

// Cuts an axis at quantiles of a sample.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns x, rounded down, within [0, count). NaN becomes 0.
inline int cell_number(double x, int count)
{
  const double at_least_zero = x > 0 ? x : 0;
  const double most = count - 1;
  return static_cast<int>(at_least_zero < most ? at_least_zero : most);
}

// Finds the stripe of a number. Numbers in order have stripes in order. Cells of equal length tell
// how many cuts are below a number. Only in a cell with a cut, it is compared.
class Stripes
{
public:
  // `values` are in order. Some of them are below a cut, and some are not, unless all are equal.
  Stripes(const std::vector<double>& values, std::size_t count)
  {
    for(std::size_t stripe = 1; stripe < count; ++stripe)
      cuts_.push_back(values[stripe * values.size() / count]);
    if(cuts_.back() == values.front())
      cuts_.back() = values.back();
    const std::size_t outliers = values.size() / 64; // at either end
    low_ = values[outliers];
    const double length = values[values.size() - 1 - outliers] - low_;
    scale_ = length > 0 ? cell_count / length : 0; // zero if the length is infinite
    for(const double cut : cuts_)
      ++cuts_below_[cell_of(cut) + 1];
    std::partial_sum(cuts_below_.begin(), cuts_below_.end(), cuts_below_.begin());
  }

  // Returns the number of cuts that are not above x.
  std::size_t operator()(double x) const
  {
    const std::size_t cell = cell_of(x);
    const std::size_t first = cuts_below_[cell], last = cuts_below_[cell + 1];
    return first == last ? first : count_cuts(x, first, last);
  }

private:
  static constexpr int cell_count = 1024;

  // The product is NaN where an infinite difference meets a scale of zero, or zero an infinite
  // scale.
  std::size_t cell_of(double x) const
  {
    return static_cast<std::size_t>(cell_number((x - low_) * scale_, cell_count));
  }

  std::size_t count_cuts(double x, std::size_t first, std::size_t last) const
  {
    const double* const cuts = cuts_.data();
    return static_cast<std::size_t>(std::upper_bound(cuts + first, cuts + last, x) - cuts);
  }

  std::vector<double> cuts_; // in order
  double low_;
  double scale_;
  std::array<std::uint16_t, cell_count + 1> cuts_below_ = {}; // in cells before this one
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STRIPES_H
