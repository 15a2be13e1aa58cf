// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H

// The filter for bounds whose square is beyond the range of Distance_filter. Coordinates, or their
// differences, are scaled by a power of two, so that the bound is about 1.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/squared_sums.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Scaled_filter
{
public:
  Scaled_filter() = default; // decides nothing

  // For differences of coordinates.
  template <class Exact>
  Scaled_filter(const Squared_bound<Exact>& bound, int dimension)
    : Scaled_filter(bound, dimension, 0)
  {}

  // For numbers up to `largest`, which do not overflow when they are scaled.
  template <class Exact>
  CGAL_RARELY_CALLED
  Scaled_filter(const Squared_bound<Exact>& bound, int dimension, double largest)
  {
    const double high = bound.reach();
    const double low = high * (1 - 0x1p-50);
    const bool needs_no_scale
      = bound.squared().first >= min_safe_square && bound.squared().second <= max_safe_square;
    if(needs_no_scale || !(low > 0) || high == std::numeric_limits<double>::infinity()
       || !bound.holds_for(Exact(low) * Exact(low)))
      return;
    const int largest_exponent = std::ilogb((std::max)(largest, high));
    scale_ = std::ldexp(1, -(std::max)({std::ilogb(high), largest_exponent - 1000, -1023}));
    const double scaled_low = low * scale_, scaled_high = high * scale_;
    filter_ = make_distance_filter(scaled_low * scaled_low * (1 - 0x1p-50),
                                   scaled_high * scaled_high * (1 + 0x1p-50), dimension);
    reach_ = std::nextafter(scaled_high, std::numeric_limits<double>::infinity());
  }

  bool is_usable() const { return reach_ > 0; }

  // What scaled coordinates are compared with. The reach has room for what they lose by underflow.
  double scale() const { return scale_; }
  double reach() const { return reach_; }
  const Distance_filter& filter() const { return filter_; }

  // Returns whether points with coordinates x(i) and y(i) are within the bound, if this is certain.
  //
  // A difference that overflows is beyond the bound, which is a double. What underflows in a scaled
  // number is less than 2^-1000 of the bound: the rounding of `low` has more room than that.
  template <class X, class Y>
  std::optional<bool> decide(const X& x, const Y& y, int dimension) const
  {
    double s = 0;
    for(int i = 0; i < dimension; ++i) {
      const double gap = (x(i) - y(i)) * scale_;
      s += gap * gap;
    }
    if(s <= filter_.inside)
      return true;
    if(s > filter_.outside)
      return false;
    return std::nullopt;
  }

private:
  double scale_ = 1;
  double reach_ = 0;
  Distance_filter filter_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H
