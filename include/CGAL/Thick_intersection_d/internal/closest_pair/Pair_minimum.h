// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PAIR_MINIMUM_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PAIR_MINIMUM_H

// The closest pair so far, and every comparison with its distance. Doubles decide where they can,
// exact numbers elsewhere; squares are compared, and no root is taken: degree 2.
//
// Of pairs at the same distance the lexicographically smallest one stays. So the pair that is left
// does not depend on the order in which pairs are offered, if none of the closest is left out.

#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Two positions, the smaller one first.
using Position_pair = std::pair<std::size_t, std::size_t>;

template <class Elements>
class Pair_minimum
{
  using Point = typename Elements::value_type;
  using Exact = Exact_number_t<Coordinate_t<Point>>;

public:
  Pair_minimum(const Elements& points, const Scene_profile& profile)
    : points_(points), dimension_(profile.dimension()),
      grid_exponent_(profile.has_grid() ? std::optional<int>(profile.grid_exponent())
                                        : std::nullopt)
  {}

  bool has_pair() const { return has_pair_; }
  const Position_pair& pair() const { return pair_; }

  // Takes the pair if it is closer, or as close and lexicographically smaller.
  void offer(std::size_t i, std::size_t j)
  {
    const Gap square = squared_distance(i, j);
    if(square.inf > outside_)
      return;
    const Position_pair candidate = std::minmax(i, j);
    if(!has_pair_)
      replace(candidate, square, std::nullopt);
    else if(is_exact_) {
      if(square.inf < outside_ || candidate < pair_)
        replace(candidate, square, std::nullopt);
    }
    else if(square.sup <= inside_)
      replace(candidate, square, std::nullopt);
    else if(candidate != pair_)
      offer_exactly(candidate, square);
  }

  void offer_pair_of(const Pair_minimum& other)
  {
    if(other.has_pair_)
      offer(other.pair_.first, other.pair_.second);
  }

  bool less(std::size_t i, std::size_t j, int axis) const
  {
    return coordinate(points_[i], axis) < coordinate(points_[j], axis);
  }

  // Whether two points are farther from each other along an axis than the closest pair is.
  bool is_beyond(std::size_t i, std::size_t j, int axis) const
  {
    if(!has_pair_)
      return false;
    const auto& p = points_[i];
    const auto& q = points_[j];
    const Gap g = gap_along(p, q, axis);
    if(g.inf * g.inf > outside_)
      return true;
    if(is_exact_ || g.sup * g.sup <= inside_)
      return false;
    const Exact difference
      = to_exact_number(coordinate(p, axis)) - to_exact_number(coordinate(q, axis));
    return Exact(difference * difference) > exact_square();
  }

  // An upper bound on the distance.
  double reach() const
  {
    return std::nextafter(std::sqrt(greatest_), std::numeric_limits<double>::infinity());
  }

  // Whether reach() is at most twice the distance. Not so for those whose squares over- or
  // underflow or are lost in the errors of the coordinates.
  bool has_tight_reach() const { return has_pair_ && least_ > 0 && greatest_ <= 4 * least_; }

  bool is_zero() const { return has_pair_ && least_ == 0 && exact_square() == Exact(0); }

private:
  // Doubles between which the squared distance lies, up to relative_error().
  Gap squared_distance(std::size_t i, std::size_t j) const
  {
    const auto& p = points_[i];
    const auto& q = points_[j];
    Gap sum = {0, 0};
    for(int axis = 0; axis < dimension_; ++axis) {
      const Gap g = gap_along(p, q, axis);
      sum.inf += g.inf * g.inf;
      sum.sup += g.sup * g.sup;
    }
    return sum;
  }

  const Exact& exact_square() const
  {
    if(!exact_square_)
      exact_square_ = exact_squared_distance(points_[pair_.first], points_[pair_.second],
                                             dimension_);
    return *exact_square_;
  }

  void offer_exactly(const Position_pair& candidate, const Gap& square)
  {
    Exact exact = exact_squared_distance(points_[candidate.first], points_[candidate.second],
                                         dimension_);
    if(exact < exact_square() || (candidate < pair_ && exact == exact_square()))
      replace(candidate, square, std::move(exact));
  }

  // The thresholds are those of make_distance_filter(), which tells why, with the distance of the
  // pair in place of the bound.
  void replace(const Position_pair& pair, const Gap& square, std::optional<Exact> exact)
  {
    static const double tiny = std::ldexp(1., -960);
    static const double above_tiny = std::ldexp(1., -950);
    static const double huge = std::ldexp(1., 1020);
    constexpr double infinity = std::numeric_limits<double>::infinity();

    const double error = relative_error(dimension_);
    has_pair_ = true;
    pair_ = pair;
    exact_square_ = std::move(exact);
    least_ = square.inf >= tiny ? (std::min)(square.inf, huge / 2) * (1 - error) : 0;
    greatest_ = square.sup <= huge ? (std::max)(square.sup * (1 + error), above_tiny) : infinity;
    is_exact_ = is_exact_in_double();
    inside_ = least_ > 0 ? least_ * (1 - error) : -1;
    outside_ = is_exact_ ? square.inf : greatest_ * (1 + error);
  }

  // Whether doubles evaluate squared distances up to that of the pair without error, and get larger
  // ones larger: the certificate of Scene_profile, with a bit to spare.
  bool is_exact_in_double() const
  {
    static const double two_to_52 = std::ldexp(1., 52);
    static const double huge = std::ldexp(1., 1000);
    return grid_exponent_ && 2 * *grid_exponent_ >= -1074 && greatest_ <= huge
           && (std::max)(dimension_, 2) * std::ldexp(greatest_, -2 * *grid_exponent_) <= two_to_52;
  }

  const Elements& points_;
  int dimension_;
  std::optional<int> grid_exponent_; // of a grid that holds all coordinates

  bool has_pair_ = false;
  Position_pair pair_ = {0, 0};
  mutable std::optional<Exact> exact_square_; // of the pair, when it was needed
  double least_ = 0; // least_ <= squared distance <= greatest_
  double greatest_ = std::numeric_limits<double>::infinity();
  bool is_exact_ = false;
  double inside_ = -1; // a computed square of at most this is less than that of the pair
  double outside_ = std::numeric_limits<double>::infinity(); // and one above this is greater
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_PAIR_MINIMUM_H
