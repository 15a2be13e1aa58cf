// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_IS_WITHIN_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_IS_WITHIN_DISTANCE_H

// The predicate of the package: is |pq| within a bound? Degree 2, exact for every kernel.

#include <CGAL/Thick_intersection_d/internal/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/Twofold_filter.h>
#include <CGAL/Thick_intersection_d/internal/coordinates.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Is_within_distance
{
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;

public:
  Is_within_distance(const Squared_bound<Exact>& bound, const Distance_filter& filter,
                     int dimension)
    : bound_(bound), filter_(filter), dimension_(dimension)
  {
    if constexpr(is_held_by_double_v<Number>)
      twofold_filter_ = Twofold_filter(bound, dimension);
  }

  bool operator()(const Point& p, const Point& q) const
  {
    double inf = 0; // the squared distance lies between inf and sup, up to relative_error()
    double sup = 0;
    for(int i = 0; i < dimension_; ++i) {
      const Gap g = gap_along(p, q, i);
      inf += g.inf * g.inf;
      sup += g.sup * g.sup;
    }
    if(sup <= filter_.inside)
      return true;
    if(inf > filter_.outside)
      return false;
    if constexpr(is_held_by_double_v<Number>)
      if(twofold_filter_.is_usable()) {
        const auto difference = [&](int i) {
          return twofold_sum(static_cast<double>(coordinate(p, i)),
                             -static_cast<double>(coordinate(q, i)));
        };
        if(const int sign = twofold_filter_.compare(difference, dimension_))
          return sign < 0;
      }
    return bound_.holds_for(exact_squared_distance(p, q, dimension_));
  }

private:
  Squared_bound<Exact> bound_;
  Distance_filter filter_;
  Twofold_filter twofold_filter_;
  int dimension_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_IS_WITHIN_DISTANCE_H
