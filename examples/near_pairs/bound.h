// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The bound of a search, as the library has it. It takes long to compile.

#ifndef NEAR_PAIRS_BOUND_H
#define NEAR_PAIRS_BOUND_H

#include "rational.h"
#include "scene.h"
#include "search_options.h"

#include <CGAL/Distance_bound.h>

#include <algorithm>
#include <cmath>

namespace near_pairs {

using Exact_bound = CGAL::Distance_bound<CGAL::Exact_rational>;

// What the user typed, for coordinates that are those of the file times 10^scale.
inline Exact_bound bound_of(const Search_options& options, int scale = 0)
{
  const CGAL::Exact_rational value
    = options.distance->value * power_of_ten(options.squared ? 2 * scale : scale);
  const Exact_bound bound = options.squared ? CGAL::within_squared_distance(value)
                                            : CGAL::within_distance(value);
  return options.open ? bound.open() : bound;
}

// By how much a longer bound exceeds the bound that was typed, so that it also has the pairs that
// rounded decimals keep beyond that one: by a thousandth of it at most, since one coordinate may be
// far beyond all others. It is 0 if there are no such pairs.
inline double excess_of_longer_bound(const Search_options& options, double rounding)
{
  const double reach = reach_of(options);
  if(rounding == 0 || !std::isfinite(reach))
    return 0;
  return std::min(2 * rounding + rounding_of(reach), reach / 1024);
}

inline Exact_bound longer_bound_of(const Search_options& options, double excess)
{
  const CGAL::Exact_rational& typed = options.distance->value;
  const double of_square = 2.01 * reach_of(options) * excess; // (r + e)^2 - r^2, rounded up
  return options.squared ? CGAL::within_squared_distance(typed + CGAL::Exact_rational(of_square))
                         : CGAL::within_distance(typed + CGAL::Exact_rational(excess));
}

} // namespace near_pairs

#endif // NEAR_PAIRS_BOUND_H
