// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H

// The filter for bounds whose square is beyond the range of Distance_filter. Coordinates are scaled
// by a power of two, so that the bound is about 1.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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

// Returns the filter for the points of a scene, all of them doubles: `plain` unless it cannot
// decide, because the square of the bound is beyond its range. Scaled coordinates do not overflow.
//
// A reach of few steps of the grid leaves no near tie. Squared distances are whole numbers of
// squared steps, of at most 53 bits up to the bound. So half a squared step less than what is
// beyond the bound decides about all of them. All doubles are on the grid of the denormal ones;
// there, the reach itself may be a step too long, which is much.
//
// Otherwise, what underflows in a scaled number is less than 2^-1000 of the bound. The reach and
// the rounding of `low` have more room than that. Only a bound below 1 that would be scaled down,
// to keep far points in range, could lose the bits that decide: `plain` leaves it to exact numbers.
template <class Exact>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
Scaled_filter scaled_filter(const Squared_bound<Exact>& bound, const Scene& scene,
                            const Scaled_filter& plain)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double high = bound.reach();
  const bool needs_no_scale
    = bound.squared().first >= min_safe_square && bound.squared().second <= max_safe_square;
  if(needs_no_scale || !(high > 0) || high == infinity)
    return plain;
  const double largest = (std::max)(scene.largest_coordinate(), high);
  const int exponent = (std::min)(-std::ilogb(high), 1000 - std::ilogb(largest));
  const double scale = std::ldexp(1, (std::min)(exponent, 1023));
  const int grid_exponent = scene.grid_exponent.value_or(-1074);
  const double scaled_step = std::ldexp(scale, grid_exponent);
  const double steps = steps_within(high, grid_exponent);
  if(scaled_step >= 0x1p-400 && steps >= 1 && steps <= 0x1p24) {
    const auto beyond = static_cast<std::int64_t>(bound.first_beyond(grid_exponent));
    const double limit = (static_cast<double>(beyond) - 0.5) * scaled_step * scaled_step;
    return {scale, std::sqrt(limit), {limit, limit}};
  }
  const double low = high * (1 - 0x1p-50) - 2 * std::numeric_limits<double>::denorm_min();
  if((exponent < 0 && high < 1) || !bound.holds_for(Exact(low) * Exact(low)))
    return plain;
  const double scaled_low = low * scale, scaled_high = high * scale;
  return {scale, scaled_high * (1 + 0x1p-50),
          make_distance_filter(scaled_low * scaled_low * (1 - 0x1p-50),
                               scaled_high * scaled_high * (1 + 0x1p-50), scene.dimension())};
}

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
using Bound_of_doubles = Squared_bound<Exact_of_doubles>;
extern template Distance_filter make_distance_filter(const Bound_of_doubles&, int);
extern template Distance_filter make_certified_filter(const Bound_of_doubles&);
extern template Distance_filter widen(const Distance_filter&, const Bound_of_doubles&, double);
extern template Scaled_filter scaled_filter(
  const Bound_of_doubles&, const Scene&, const Scaled_filter&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_SCALED_FILTER_H
