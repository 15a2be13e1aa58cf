// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H

// Decides whether |pq| <= r + s, for balls with individual radii. Degree 2, exact for every kernel.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Uncertain.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Decides whether |pq| <= r + s in integers, for coordinates and radii that are doubles.
//
// The numbers of the two balls have a grid 2^e Z of their own. Let S = (r + s) / 2^e < 2^62.
//
// 1. Let fl(|x - y|) be the result of one rounded subtraction. If it is above a double that is at
//    least r + s, then |x - y| is above r + s (Lemma M, doc/proofs.md), so the balls are apart.
// 2. Otherwise T = |x - y| / 2^e is below 2^63, so T is the difference of x / 2^e and y / 2^e
//    modulo 2^64, however large these quotients are. Integers compare T with S.
// 3. Integers of 128 bits hold the sum of up to eight squares of T <= S, and S^2.
//
// The balls have the centers x(i) and y(i), for i < dimension, and the radii r and s. Returns
// nothing if the numbers do not fit.
template <class X, class Y>
std::optional<bool> do_balls_intersect_in_integers(const X& x, double r, const Y& y, double s,
                                                   int dimension)
{
  constexpr int max_dimension = 8;
  constexpr double max_steps = 0x1p61; // in each radius
  Double_grid grid;
  grid.add(r);
  grid.add(s);
  for(int i = 0; i < dimension; ++i) {
    grid.add(x(i));
    grid.add(y(i));
  }
  const int e = grid.exponent();
  if(dimension > max_dimension || !(std::ldexp(r, -e) < max_steps)
     || !(std::ldexp(s, -e) < max_steps))
    return std::nullopt;

  const double reach = std::nextafter(r + s, std::numeric_limits<double>::infinity());
  const std::uint64_t steps = steps_modulo_2_64(r, e) + steps_modulo_2_64(s, e);
  Uint128 sum = 0;
  for(int i = 0; i < dimension; ++i) {
    if(std::fabs(x(i) - y(i)) > reach)
      return false;
    const std::uint64_t difference = steps_modulo_2_64(x(i), e) - steps_modulo_2_64(y(i), e);
    const std::uint64_t gap = x(i) < y(i) ? 0 - difference : difference;
    if(gap > steps)
      return false;
    sum += Uint128(gap) * gap;
  }
  return sum <= Uint128(steps) * steps;
}

// Decides about two balls by their boxes, unless it is a near tie. A sweep has the boxes at hand.
// The balls are anywhere in memory.
//
// For boxes of ball_interval(), along all axes, of balls whose numbers are doubles.
//
// The sum of the ends of a box is twice the center, and their difference is twice the radius. Let w
// be 2^-52, which bounds the error of an operation in every rounding mode, and M the largest
// absolute end. An end is off by at most 2wM, so a computed sum or difference of ends is off by at
// most 6wM, and the difference of two sums by 16wM. In up to eight dimensions, twice the distance
// of the centers is off by at most 46wM, and twice the sum of the radii by 16wM. The slack below is
// at least 128wM. The rest of it covers the rounding of radii +- slack, and underflow.
struct Ball_box_filter
{
  template <std::size_t Axes>
  static Uncertain<bool> do_intersect(const std::array<Interval, Axes>& a,
                                      const std::array<Interval, Axes>& b)
  {
    static_assert(Axes <= 8);
    const double radii = (a[0].high - a[0].low) + (b[0].high - b[0].low);
    double twice_largest_end = radii;
    double s = 0;
    for(std::size_t axis = 0; axis < Axes; ++axis) {
      const double center_of_a = a[axis].low + a[axis].high;
      const double center_of_b = b[axis].low + b[axis].high;
      twice_largest_end += std::fabs(center_of_a) + std::fabs(center_of_b);
      s += (center_of_a - center_of_b) * (center_of_a - center_of_b);
    }
    const double slack = 0x1p-46 * twice_largest_end;
    const double error = relative_error(Axes);
    const double least = radii - slack, most = radii + slack;
    if(!(slack * slack > min_safe_square && most * most < max_safe_square))
      return Uncertain<bool>::indeterminate();
    if(s > most * most * (1 + error))
      return false;
    if(least > 0 && s <= least * least * (1 - error))
      return true;
    return Uncertain<bool>::indeterminate();
  }
};

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
    const Exact sum = to_exact<Exact>(a.second) + to_exact<Exact>(b.second);
    return exact_squared_distance(a.first, b.first, dimension_) <= Exact(sum * sum);
  }

  double error_;
  int dimension_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_H
