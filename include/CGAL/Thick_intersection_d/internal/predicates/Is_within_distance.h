// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H

// Decides whether |pq| <= r. Each search of points within a bound makes this object once. It asks a
// filter in doubles, integers and exact numbers, in this order. Degree 2.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Integer_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Scaled_filter.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A value that is made when the first thread asks for it, because most searches never do. Several
// threads may ask at once; all but one of them wait.
template <class Value>
class On_demand
{
public:
  On_demand() = default;

  // A copy makes a value of its own.
  On_demand(const On_demand&) {}
  On_demand& operator=(const On_demand&)
  {
    is_made_ = false;
    value_.reset();
    return *this;
  }

  // Returns the value, which is what the first call of `make` that did not throw returned.
  template <class Make>
  const Value& get(const Make& make)
  {
    if(!is_made_.load(std::memory_order_acquire)) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if(!value_) {
        value_.emplace(make());
        is_made_.store(true, std::memory_order_release);
      }
    }
    return *value_;
  }

private:
  std::mutex mutex_;
  std::atomic<bool> is_made_ = false;
  std::optional<Value> value_;
};

template <class Point>
class Is_within_distance
{
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;
  using Bound = Squared_bound<Exact>;

public:
  // For points of any coordinates.
  Is_within_distance(const Bound& bound, int dimension)
    : bound_(bound), dimension_(dimension), filter_(make_distance_filter(bound, dimension)),
      filter_of_doubles_{1, bound.reach(), filter_}
  {
    if(is_held_by_double_v<Number>)
      take_integers(Arithmetic_tier::INT128, std::nullopt, dimension);
  }

  // For the points of a scene, and no other points. Doubles decide near ties if `tier` is DOUBLE,
  // integers if it is INT64 or INT128, and exact numbers if it is FILTERED_EXACT. The first two are
  // to be exact for the scene. INT128 need not be: what does not fit is left to exact numbers.
  // Counts in `counts` which arithmetic decides, unless `counts` is null.
  Is_within_distance(const Bound& bound, const Scene& scene, Arithmetic_tier tier,
                     Shared_decision_counts* counts = nullptr)
    : bound_(bound), dimension_(scene.dimension()),
      filter_(tier == Arithmetic_tier::DOUBLE ? make_certified_filter(bound)
                                              : make_distance_filter(bound, scene.dimension())),
      filter_of_doubles_{1, padded(bound.reach(), scene.error),
                         widen(filter_, bound, scene.error)},
      shared_counts_(counts)
  {
    if(scene.error != 0 || tier == Arithmetic_tier::DOUBLE)
      return;
    take_integers(tier, scene.grid_exponent, scene.extended_axis_count());
    filter_of_doubles_ = scaled_filter(bound, scene, filter_of_doubles_);
  }

  int dimension() const { return dimension_; }

  static std::pair<double, double> interval(const Point& p, int axis)
  {
    return coordinate_bounds(p, axis);
  }

  // An upper bound on the distance along an axis of points within the bound.
  double reach() const { return bound_.reach(); }

  // The filter for coordinates, or for bounds of coordinates.
  const Distance_filter& filter() const { return filter_; }

  // The whole question.
  bool operator()(const Point& p, const Point& q) const
  {
    Decision_counts counts;
    std::optional<bool> is_within = decide_by_filter(p, q, counts);
    if(!is_within && has_integers_) { // so the bounds of a coordinate are equal
      const auto x = [&](int i) { return coordinate_bounds(p, i).first; };
      const auto y = [&](int i) { return coordinate_bounds(q, i).first; };
      is_within = integers()->decide(x, y, dimension_);
      if(is_within)
        counts.add(tier_);
    }
    if(!is_within)
      is_within = decide_exactly(p, q, counts);
    publish(counts);
    return *is_within;
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
      = to_exact<Exact>(coordinate(p, axis)) - to_exact<Exact>(coordinate(q, axis));
    return bound_.holds_for(Exact(difference * difference));
  }

  // The first question, for searches that hold the points of the scene as doubles, times a power of
  // two. Each double is at most its coordinate, and is off by at most the error of the scene; what
  // scaled ones lose by underflow besides, the reach and the filter have room for.
  const Scaled_filter& filter_of_doubles() const { return filter_of_doubles_; }

  // Returns the least number of squared steps of the grid 2^e Z that is not within the bound. A
  // reach must have fewer than 2^31 steps.
  std::uint64_t first_square_beyond(int grid_exponent) const
  {
    return static_cast<std::uint64_t>(bound_.first_beyond(grid_exponent));
  }

  // The second question, about near ties of doubles. Returns what decides them, or nullptr if only
  // the points themselves do.
  const Integer_distance* integers() const
  {
    return !has_integers_ ? nullptr : &integers_.get([this] {
      return Integer_distance(bound_, grid_exponent_, tier_);
    });
  }

  // The counts that all threads share, or nullptr.
  Shared_decision_counts* shared_counts() const { return shared_counts_; }

  // The last question, for points that the first two questions left undecided. It asks the filter
  // again, because the bounds of these coordinates are often closer than the error of the scene.
  bool decide_undecided(const Point& p, const Point& q, Decision_counts& counts) const
  {
    const std::optional<bool> is_within = decide_by_filter(p, q, counts);
    return is_within ? *is_within : decide_exactly(p, q, counts);
  }

  // Adds counts to the counts that all threads share, if there are such counts.
  void publish(const Decision_counts& counts) const
  {
    if(shared_counts_ != nullptr)
      shared_counts_->add(counts);
  }

private:
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

  bool decide_exactly(const Point& p, const Point& q, Decision_counts& counts) const
  {
    counts.add(Arithmetic_tier::FILTERED_EXACT);
    return bound_.holds_for(exact_squared_distance(p, q, dimension_));
  }

  // Prepares integers for near ties of doubles, on the grid of the scene or on the finest one.
  void take_integers(Arithmetic_tier tier, const std::optional<int>& grid_exponent, int axis_count)
  {
    if(tier == Arithmetic_tier::FILTERED_EXACT || bound_.reach() > 0x1p1022)
      return;
    tier_ = tier;
    grid_exponent_ = tier == Arithmetic_tier::INT64
                       ? *grid_exponent : finest_grid_exponent(bound_.reach(), axis_count);
    has_integers_ = true;
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
  Scaled_filter filter_of_doubles_;
  Arithmetic_tier tier_ = Arithmetic_tier::FILTERED_EXACT;
  int grid_exponent_ = 0; // of the integers
  bool has_integers_ = false; // whether they may decide near ties
  mutable On_demand<Integer_distance> integers_;
  Shared_decision_counts* shared_counts_ = nullptr;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_IS_WITHIN_DISTANCE_H
