// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H

// The filter for bounds whose square is beyond the range of Distance_filter. Coordinates are scaled
// by a power of two, so that the bound is about 1.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/squared_sums.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What coordinates times the scale are compared with. The reach bounds the distance along an axis.
struct Scaled_filter
{
  double scale = 1; // a power of two
  double reach;
  Distance_filter filter;
};

// Returns the filter for coordinates up to `largest`, which do not overflow when they are scaled:
// `plain` unless it cannot decide, because the square of the bound is beyond its range.
//
// What underflows in a scaled number is less than 2^-1000 of the bound. The reach and the rounding
// of `low` have more room than that.
template <class Exact>
CGAL_RARELY_CALLED
Scaled_filter scaled_filter(const Squared_bound<Exact>& bound, int dimension, double largest,
                            const Scaled_filter& plain)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double high = bound.reach();
  const double low = high * (1 - 0x1p-50);
  const bool needs_no_scale
    = bound.squared().first >= min_safe_square && bound.squared().second <= max_safe_square;
  if(needs_no_scale || !(low > 0) || high == infinity
     || !bound.holds_for(Exact(low) * Exact(low)))
    return plain;
  const int largest_exponent = std::ilogb((std::max)(largest, high));
  const double scale
    = std::ldexp(1, -(std::max)({std::ilogb(high), largest_exponent - 1000, -1023}));
  const double scaled_low = low * scale, scaled_high = high * scale;
  return {scale, std::nextafter(scaled_high, infinity),
          make_distance_filter(scaled_low * scaled_low * (1 - 0x1p-50),
                               scaled_high * scaled_high * (1 + 0x1p-50), dimension)};
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H
