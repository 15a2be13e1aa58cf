// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H

// Decides whether |pq| <= r + s, for balls with individual radii. Degree 2, exact for every kernel.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/squared_sums.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_balls_intersect_in_integers.h>

#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Point>
class Do_balls_intersect
{
  using Number = Coordinate_t<Point>;
  using Exact = Exact_number_t<Number>;

public:
  using Ball = std::pair<Point, Number>;

  explicit Do_balls_intersect(int dimension)
    : error_(2 * relative_error(dimension)), dimension_(dimension)
  {}

  bool operator()(const Ball& a, const Ball& b) const
  {
    const std::pair<double, double> r = bounds(a.second);
    const std::pair<double, double> s = bounds(b.second);
    const double min_sum = r.first + s.first;
    const double max_sum = r.second + s.second;
    const double min_square = min_sum * min_sum;
    const double max_square = max_sum * max_sum;
    const Gap square = squared_distance_bounds(a.first, b.first, dimension_);

    // The sum of the radii and its square add the error of three roundings, which is less than
    // relative_error(). Exact numbers decide if there may be underflow or overflow.
    if(min_square > min_safe_square && max_square < max_safe_square) {
      if(square.sup <= min_square * (1 - error_))
        return true;
      if(square.inf > max_square * (1 + error_))
        return false;
    }
    return decide_near_tie(a, b);
  }

private:
  // Integers decide most ties, because the numbers of two balls have a grid of their own.
  bool decide_near_tie(const Ball& a, const Ball& b) const
  {
    if constexpr(is_held_by_double_v<Number>) {
      const auto x = [&](int i) { return static_cast<double>(coordinate(a.first, i)); };
      const auto y = [&](int i) { return static_cast<double>(coordinate(b.first, i)); };
      const auto do_intersect = do_balls_intersect_in_integers(
        x, static_cast<double>(a.second), y, static_cast<double>(b.second), dimension_);
      if(do_intersect)
        return *do_intersect;
    }
    return do_intersect_exactly(a, b);
  }

  bool do_intersect_exactly(const Ball& a, const Ball& b) const
  {
    const Exact sum = to_exact_number(a.second) + to_exact_number(b.second);
    return exact_squared_distance(a.first, b.first, dimension_) <= Exact(sum * sum);
  }

  double error_;
  int dimension_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H
