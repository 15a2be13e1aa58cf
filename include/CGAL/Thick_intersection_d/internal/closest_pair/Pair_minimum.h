// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PAIR_MINIMUM_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PAIR_MINIMUM_H

// The closest pair so far, and all comparisons with its distance. Doubles decide where they can,
// and exact numbers elsewhere. It compares squares and takes no root, so the degree is 2.
//
// Squares are those of differences times a power of two, the scale, so that the square of the least
// distance neither over- nor underflows. The scale is 1 where doubles hold the square anyway.
//
// Among pairs at the same distance, the lexicographically smallest pair stays. So if all closest
// pairs are offered, the pair that remains does not depend on the order of offers.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Twofold_distance.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
class Pair_minimum
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;

public:
  // Takes points of any scene.
  Pair_minimum(const Elements& points, int dimension) : points_(points), dimension_(dimension) {}

  // Takes the points of the scene.
  Pair_minimum(const Elements& points, const Scene& scene)
    : points_(points), dimension_(scene.dimension()), grid_exponent_(scene.grid_exponent)
  {}

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Pair_minimum(const Pair_minimum&) = default;

  const Position_pair& pair() const { return pair_; }

  // Takes the pair if it is closer, or as close and lexicographically smaller.
  void offer(std::size_t i, std::size_t j)
  {
    if(scale_exponent_ != 0)
      offer_at_scale(i, j);
    else if(const Gap square = squared_distance_bounds(points_[i], points_[j],
                                                       dimension_or<Point>(dimension_));
            !(square.inf > filter_.outside))
      offer_between(i, j, square);
  }

  // As offer(), of a pair that is as close.
  void offer_tie(std::size_t i, std::size_t j)
  {
    pair_ = (std::min)(pair_, Position_pair(std::minmax(i, j)));
  }

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void offer_pair_of(const Pair_minimum& other)
  {
    if(other.has_pair_)
      offer(other.pair_.first, other.pair_.second);
  }

  bool less(std::size_t i, std::size_t j, int axis) const
  {
    return coordinate(points_[i], axis) < coordinate(points_[j], axis);
  }

  // Whether the distance of two points along an axis is greater than the distance of the pair.
  bool is_beyond(std::size_t i, std::size_t j, int axis) const
  {
    if(!has_pair_)
      return false;
    const Gap g = scaled_gap(points_[i], points_[j], axis);
    if(g.inf * g.inf > filter_.outside)
      return true;
    if(is_exact_ || g.sup * g.sup <= filter_.inside)
      return false;
    const Exact difference = to_exact<Exact>(coordinate(points_[i], axis))
                             - to_exact<Exact>(coordinate(points_[j], axis));
    return Exact(difference * difference) > exact_square();
  }

  // An upper bound on the distance.
  double reach() const
  {
    return std::nextafter(scaled_reach() / scale_, std::numeric_limits<double>::infinity());
  }

  // The square of the distance.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED const Exact& exact_square() const
  {
    if(!exact_square_)
      exact_square_ = exact_squared_distance(points_[pair_.first], points_[pair_.second],
                                             dimension_);
    return *exact_square_;
  }

  // Whether reach() is at most twice the distance, or the next double, or beyond the doubles. False
  // if points are equal, or if the errors of the coordinates hide the distance.
  bool has_tight_reach() const
  {
    return has_pair_ && min_square_ > 0
           && (max_square_ <= 4 * min_square_ || min_square_ > max_safe_square / 4);
  }

  bool is_zero() const { return has_pair_ && min_square_ == 0 && CGAL::is_zero(exact_square()); }

private:
  double scaled_reach() const
  {
    return std::nextafter(std::sqrt(max_square_), std::numeric_limits<double>::infinity());
  }

  // Offers a pair whose computed squared distance is between the doubles of `square`. Not inline,
  // so that loops that offer pairs stay short.
  BOOST_NOINLINE void offer_between(std::size_t i, std::size_t j, Gap square)
  {
    if(square.inf > filter_.outside)
      return;
    const Position_pair candidate = std::minmax(i, j);
    if(!has_pair_)
      replace(candidate, square);
    else if(is_exact_) {
      if(square.inf < filter_.outside || candidate < pair_)
        replace(candidate, square);
    }
    else if(square.sup <= filter_.inside)
      replace(candidate, square);
    else if(candidate != pair_)
      offer_near_tie(candidate, square);
  }

  BOOST_NOINLINE void offer_near_tie(const Position_pair& candidate, const Gap& square)
  {
    if(const auto order = compare_by_doubles(candidate)) {
      if(*order < 0 || (*order == 0 && candidate < pair_))
        replace(candidate, square);
    }
    else
      offer_exactly(candidate, square);
  }

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void offer_exactly(const Position_pair& candidate, const Gap& square)
  {
    Exact exact = exact_squared_distance(points_[candidate.first], points_[candidate.second],
                                         dimension_);
    const Sign order = compare_exactly(exact, exact_square());
    if(order == SMALLER || (order == EQUAL && candidate < pair_)) {
      replace(candidate, square);
      exact_square_ = std::move(exact);
    }
  }

  // Compares the distance of a near tie with that of the pair. Returns nothing if only exact
  // numbers can tell.
  std::optional<int> compare_by_doubles(const Position_pair& candidate) const
  {
    if constexpr(is_held_by_double_v<Coordinate_t<Point>>)
      if(min_square_ > min_twofold_square && max_square_ < max_twofold_square
         && dimension_ <= Twofold_distance::max_dimension) {
        if(!twofold_)
          twofold_ = twofold_distance(pair_);
        return twofold_distance(candidate).compare(*twofold_);
      }
    return std::nullopt;
  }

  BOOST_NOINLINE Twofold_distance twofold_distance(const Position_pair& pair) const
  {
    const auto coordinate_of = [&](std::size_t position) {
      return [this, position](int axis) { // the point may be made for the occasion
        return static_cast<double>(coordinate(points_[position], axis));
      };
    };
    return Twofold_distance(coordinate_of(pair.first), coordinate_of(pair.second), dimension_,
                            scale_);
  }

  void offer_at_scale(std::size_t i, std::size_t j)
  {
    offer_between(i, j, scaled_square_bounds(i, j));
  }

  // As squared_distance_bounds(), of differences times the scale.
  Gap scaled_square_bounds(std::size_t i, std::size_t j) const
  {
    const auto& p = points_[i];
    const auto& q = points_[j];
    Gap sum = {0, 0};
    for(int axis = 0; axis < dimension_; ++axis) {
      const Gap g = scaled_gap(p, q, axis);
      sum.inf += g.inf * g.inf;
      sum.sup += g.sup * g.sup;
    }
    return sum;
  }

  // Returns doubles that enclose the scaled distance of two points along an axis. If a difference
  // overflows, to infinity or, as some rounding modes have it, to the largest double, that of the
  // halves does not. What halving loses is less than 2^-1074.
  Gap scaled_gap(const Point& p, const Point& q, int axis) const
  {
    const Gap g = gap_along(p, q, axis);
    if(g.sup < (std::numeric_limits<double>::max)())
      return {g.inf * scale_, g.sup * scale_};
    const std::pair<double, double> x = coordinate_bounds(p, axis);
    const std::pair<double, double> y = coordinate_bounds(q, axis);
    const auto half = [](const std::pair<double, double>& b) {
      return std::pair<double, double>(b.first / 2, b.second / 2);
    };
    const Gap g_of_halves = gap(half(x), half(y));
    return {2 * scale_ * g_of_halves.inf, 2 * scale_ * g_of_halves.sup};
  }

  // Chooses the scale for the pair, and returns the bounds of its squared distance at this scale.
  // If its points are equal, any other distance has a square beyond min_safe_threshold.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Gap choose_scale()
  {
    double size = 0;
    for(int axis = 0; axis < dimension_; ++axis)
      size = (std::max)(size, gap_along(points_[pair_.first], points_[pair_.second], axis).sup);
    size = (std::min)(size, (std::numeric_limits<double>::max)()); // a difference may overflow
    constexpr int min_exponent = -1000;
    const int exponent = size > 0 ? (std::max)(std::ilogb(size), min_exponent) : min_exponent;
    scale_exponent_ = is_plain(size * size) ? 0 : -exponent;
    scale_ = std::ldexp(1, scale_exponent_);
    return scaled_square_bounds(pair_.first, pair_.second);
  }

  static bool is_plain(double square) { return square >= 0x1p-900 && square <= 0x1p1000; }

  // Takes a pair. Its computed squared distance is between the doubles of `square`.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void replace(const Position_pair& pair, Gap square)
  {
    const double error = relative_error(dimension_);
    has_pair_ = true;
    pair_ = pair;
    exact_square_.reset();
    twofold_.reset();
    if(scale_exponent_ != 0 || !is_plain(square.sup))
      square = choose_scale();
    min_square_ = square.inf >= min_safe_square
                    ? (std::min)(square.inf, max_safe_square / 2) * (1 - error) : 0;
    max_square_ = square.sup <= max_safe_square
                    ? (std::max)(square.sup * (1 + error), min_safe_threshold)
                    : std::numeric_limits<double>::infinity();
    is_exact_ = grid_exponent_
                && are_squares_exact_in_double(scaled_reach(), *grid_exponent_ + scale_exponent_,
                                               dimension_);
    filter_ = make_distance_filter(min_square_, max_square_, dimension_);
    if(is_exact_)
      filter_.outside = square.inf;
  }

  const Elements& points_;
  int dimension_;
  std::optional<int> grid_exponent_; // of the grid of the scene

  bool has_pair_ = false;
  Position_pair pair_ = {0, 0};
  mutable std::optional<Exact> exact_square_;       // of the pair, once it was needed
  mutable std::optional<Twofold_distance> twofold_; // of the pair, once it was needed
  int scale_exponent_ = 0;
  double scale_ = 1;
  double min_square_ = 0; // min_square_ <= squared distance at this scale <= max_square_
  double max_square_ = std::numeric_limits<double>::infinity();
  bool is_exact_ = false;  // whether doubles compute squares up to that of the pair without error
  Distance_filter filter_; // the distance of the pair at this scale is its bound
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PAIR_MINIMUM_H
