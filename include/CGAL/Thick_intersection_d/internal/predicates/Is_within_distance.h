// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H

// The predicate of the package: is |pq| within a bound? Degree 2, exact for every kernel.

#include <CGAL/Thick_intersection_d/internal/predicates/Near_tie_test.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Is_within_distance
{
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;

public:
  // For points of any coordinates.
  Is_within_distance(const Squared_bound<Exact>& bound, const Distance_filter& filter,
                     int dimension)
    : Is_within_distance(bound, filter, make_close_call<Number>(bound, dimension), dimension,
                         nullptr)
  {}

  // With what decides the pairs that the filter does not, before the exact numbers do. Calls add
  // to `counts` which arithmetic decides, unless it is null.
  Is_within_distance(const Squared_bound<Exact>& bound, const Distance_filter& filter,
                     const Close_call& close_call, int dimension, Shared_decision_counts* counts)
    : bound_(bound), filter_(filter), close_call_(close_call), dimension_(dimension),
      shared_counts_(counts)
  {}

  const Squared_bound<Exact>& bound() const { return bound_; }
  const Distance_filter& filter() const { return filter_; }
  const Close_call& close_call() const { return close_call_; }
  Shared_decision_counts* shared_counts() const { return shared_counts_; }

  bool operator()(const Point& p, const Point& q) const
  {
    Decision_counts counts;
    const bool is_within = decide(p, q, counts);
    if(shared_counts_ != nullptr)
      shared_counts_->add(counts);
    return is_within;
  }

  // Adds to `counts` which arithmetic decides.
  bool decide(const Point& p, const Point& q, Decision_counts& counts) const
  {
    double inf = 0; // the squared distance lies between inf and sup, up to relative_error()
    double sup = 0;
    for(int i = 0; i < dimension_; ++i) {
      const Gap g = gap_along(p, q, i);
      inf += g.inf * g.inf;
      sup += g.sup * g.sup;
    }
    if(sup <= filter_.inside) {
      counts.add(Arithmetic_tier::DOUBLE);
      return true;
    }
    if(inf > filter_.outside)
      return false;
    // It decides something only if the coordinates are doubles, which their bounds are then.
    const auto x = [&](int i) { return coordinate_bounds(p, i).first; };
    const auto y = [&](int i) { return coordinate_bounds(q, i).first; };
    if(const std::optional<bool> is_within = close_call_.decide(x, y, dimension_, counts))
      return *is_within;
    counts.add(Arithmetic_tier::FILTERED_EXACT);
    return bound_.holds_for(exact_squared_distance(p, q, dimension_));
  }

private:
  Squared_bound<Exact> bound_;
  Distance_filter filter_;
  Close_call close_call_;
  int dimension_;
  Shared_decision_counts* shared_counts_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H
