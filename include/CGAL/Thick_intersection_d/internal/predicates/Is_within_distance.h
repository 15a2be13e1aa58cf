// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H

// Decides whether |pq| <= r. Each search of points within a bound makes this object once. It asks a
// filter in doubles, integers or doubles of twice the precision, and exact numbers, in this order.
// Degree 2.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Near_tie_predicate.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Near_ties_on_demand.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Is_within_distance
{
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;
  using Bound = Squared_bound<Exact>;

public:
  // For points of any coordinates.
  CGAL_RARELY_CALLED Is_within_distance(const Bound& bound, int dimension)
    : bound_(bound), dimension_(dimension), filter_(make_distance_filter(bound, dimension)),
      filter_of_doubles_(filter_), reach_of_doubles_(bound.reach())
  {
    if constexpr(is_held_by_double_v<Number>)
      near_tie_ = Near_tie_predicate(bound, dimension);
  }

  // For the points of a scene whose grid is not known.
  CGAL_RARELY_CALLED
  Is_within_distance(const Bound& bound, const Scene& scene, const Near_ties_on_demand& near_ties,
                     Shared_decision_counts* counts)
    : Is_within_distance(bound, scene, Arithmetic_tier::FILTERED_EXACT, counts)
  {
    near_ties_ = &near_ties;
  }

  // For the points of a scene, and no other points. Uses the arithmetic of `tier`, which is to be
  // exact for the scene. Counts in `counts` which arithmetic decides, unless `counts` is null.
  CGAL_RARELY_CALLED
  Is_within_distance(const Bound& bound, const Scene& scene, Arithmetic_tier tier,
                     Shared_decision_counts* counts = nullptr)
    : bound_(bound), dimension_(scene.dimension()),
      filter_(tier == Arithmetic_tier::DOUBLE ? make_certified_filter(bound)
                                              : make_distance_filter(bound, scene.dimension())),
      near_tie_(bound, scene, tier), are_doubles_exact_(scene.error == 0),
      filter_of_doubles_(widen(filter_, bound, scene.error)),
      reach_of_doubles_(padded(bound.reach(), scene.error)), shared_counts_(counts)
  {
    if(are_doubles_exact_ && tier != Arithmetic_tier::DOUBLE)
      scale_doubles(Scaled_filter(bound, scene.dimension(), scene.largest_coordinate()));
  }

  int dimension() const { return dimension_; }

  // An upper bound on the distance along an axis of points within the bound.
  double reach() const { return bound_.reach(); }

  // The filter for coordinates, or for bounds of coordinates.
  const Distance_filter& filter() const { return filter_; }

  // The whole question.
  bool operator()(const Point& p, const Point& q) const
  {
    Decision_counts counts;
    const bool is_within = decide(p, q, counts);
    publish(counts);
    return is_within;
  }

  // Whether two points are within the bound along one axis: |p_i - q_i| <= r.
  bool is_within_along(const Point& p, const Point& q, int axis) const
  {
    const Gap g = gap_along(p, q, axis);
    if(g.sup * g.sup <= filter_.inside)
      return true;
    if(g.inf * g.inf > filter_.outside)
      return false;
    const Exact difference
      = to_exact_number(coordinate(p, axis)) - to_exact_number(coordinate(q, axis));
    return bound_.holds_for(Exact(difference * difference));
  }

  // The first question, for searches that hold the points of the scene as doubles, times a power of
  // two. Each double is at most its coordinate, and is off by at most the error of the scene; what
  // scaled ones lose by underflow besides, the reach and the filter have room for.
  double scale_of_doubles() const { return scale_of_doubles_; }
  double reach_of_doubles() const { return reach_of_doubles_; }
  const Distance_filter& filter_of_doubles() const { return filter_of_doubles_; }

  // Returns the least number of squared steps of the grid 2^e Z that is not within the bound. A
  // reach is to have fewer than 2^31 steps.
  std::uint64_t first_square_beyond(int grid_exponent) const
  {
    const double steps = steps_within(bound_.reach(), grid_exponent);
    return bound_.template first_beyond<std::uint64_t>(grid_exponent,
                                                       2 * (std::ilogb(steps + 1) + 1));
  }

  // The second question: returns whether points with the doubles x(i) and y(i), for i < `axes`, are
  // within the bound. Returns nothing if only the points themselves can show this.
  template <class X, class Y>
  std::optional<bool> decide_near_tie(const X& x, const Y& y, int axes,
                                      Decision_counts& counts) const
  {
    return near_tie().decide(x, y, axes, counts);
  }

  // The last question, for points that the first two questions left undecided. It asks the filter
  // again, because the bounds of these coordinates are often closer than the error of the scene.
  bool decide_undecided(const Point& p, const Point& q, Decision_counts& counts) const
  {
    if(!are_doubles_exact_)
      if(const std::optional<bool> is_within = decide_by_filter(p, q, counts))
        return *is_within;
    return decide_exactly(p, q, counts);
  }

  // Adds counts to the counts that all threads share, if there are such counts.
  void publish(const Decision_counts& counts) const
  {
    if(shared_counts_ != nullptr)
      shared_counts_->add(counts);
  }

private:
  void scale_doubles(const Scaled_filter& scaled)
  {
    if(!scaled.is_usable())
      return;
    scale_of_doubles_ = scaled.scale();
    filter_of_doubles_ = scaled.filter();
    reach_of_doubles_ = scaled.reach();
  }

  bool decide(const Point& p, const Point& q, Decision_counts& counts) const
  {
    if(const std::optional<bool> is_within = decide_by_filter(p, q, counts))
      return *is_within;
    if(are_doubles_exact_) { // so the bounds of a coordinate are equal
      const auto x = [&](int i) { return coordinate_bounds(p, i).first; };
      const auto y = [&](int i) { return coordinate_bounds(q, i).first; };
      if(const std::optional<bool> is_within = near_tie().decide(x, y, dimension_, counts))
        return *is_within;
    }
    return decide_exactly(p, q, counts);
  }

  std::optional<bool> decide_by_filter(const Point& p, const Point& q,
                                       Decision_counts& counts) const
  {
    const Gap s = squared_distance_bounds(p, q, dimension_or<Point>(dimension_));
    if(s.sup <= filter_.inside) {
      counts.add(Arithmetic_tier::DOUBLE);
      return true;
    }
    if(s.inf > filter_.outside)
      return false;
    return std::nullopt;
  }

  const Near_tie_predicate& near_tie() const
  {
    return near_ties_ == nullptr ? near_tie_ : near_ties_->get();
  }

  bool decide_exactly(const Point& p, const Point& q, Decision_counts& counts) const
  {
    counts.add(Arithmetic_tier::FILTERED_EXACT);
    return bound_.holds_for(exact_squared_distance(p, q, dimension_));
  }

  // Doubles that are off by up to `error`, all in one direction, differ by up to `error` more.
  static double padded(double reach, double error)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return error == 0 ? reach : std::nextafter(reach + error, infinity);
  }

  Bound bound_;
  int dimension_;
  Distance_filter filter_;
  Near_tie_predicate near_tie_;
  const Near_ties_on_demand* near_ties_ = nullptr; // instead, if there are any
  bool are_doubles_exact_ = is_held_by_double_v<Number>;
  double scale_of_doubles_ = 1;
  Distance_filter filter_of_doubles_;
  double reach_of_doubles_;
  Shared_decision_counts* shared_counts_ = nullptr;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H
