// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FEW_CLOSEST_PAIR_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FEW_CLOSEST_PAIR_H

// The closest pair of few points, and a close one: each with each, without a scene and without
// memory but the stack.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/squared_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Pair_minimum.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/few_coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Plain_is_within.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
class Few_closest_pair
{
  using Point = typename Elements::value_type;
  static constexpr int dimension = dimension_or<Point>(0);
  static constexpr std::size_t max_size = dimension == 2 ? max_few_points / 2 : max_few_points;

public:
  // Cells are faster for more points in the plane. No pair is left to the search of many points,
  // which knows what to say.
  static bool takes(const Elements& points)
  {
    return points.size() >= 2 && points.size() <= max_size;
  }

  // Takes few points.
  explicit Few_closest_pair(const Elements& points) : points_(points)
  {
    check_denormals();
    are_finite_ = read_coordinates(points, 0, points.size(), x_, 0);
  }

  bool are_finite() const { return are_finite_; }

  // Returns the closest pair of finite points.
  //
  // Invariant: the pair has the least computed square so far. All other pairs so far are farther,
  // unless `has_tie`.
  Position_pair find() const
  {
    constexpr double slack = 0x1p-46; // more than squares of one distance differ by
    Position_pair pair(0, 1);
    double square = std::numeric_limits<double>::infinity();
    double near = square; // as far as a tie
    bool has_tie = true;
    for(std::size_t i = 0; i < points_.size(); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j)
        if(const double s = computed_square(x_, i, j); s <= near) {
          has_tie = s >= square * (1 - slack);
          if(s < square) {
            square = s;
            near = s * (1 + slack);
            pair = {i, j};
          }
        }
    const bool is_safe = square >= min_safe_square && square <= max_safe_square;
    return has_tie || !is_safe ? find_among_ties(square) : pair;
  }

  // Returns the first pair within a bound, or (0, 0) if there is none.
  template <class Is_within>
  Position_pair find_within(Is_within& is_within) const
  {
    const Distance_filter filter = is_within.filter();
    for(std::size_t i = 0; i < points_.size(); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j) {
        const double s = computed_square(x_, i, j);
        if(s <= filter.outside
           && (s <= filter.inside || is_within.decide_undecided(points_[i], points_[j])))
          return {i, j};
      }
    return {0, 0};
  }

private:
  // Returns the closest pair, of which `square` is the least computed square.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Position_pair find_among_ties(double square) const
  {
    const double most = make_distance_filter(
      square, square * (1 + 2 * relative_error(dimension)), dimension).outside;
    Pair_minimum<Elements> minimum(points_, dimension);
    for(std::size_t i = 0; i < points_.size(); ++i)
      for(std::size_t j = i + 1; j < points_.size(); ++j)
        if(computed_square(x_, i, j) <= most)
          minimum.offer(i, j);
    return minimum.pair();
  }

  const Elements& points_;
  Few_coordinates<Point, max_size> x_;
  bool are_finite_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_FEW_CLOSEST_PAIR_H
