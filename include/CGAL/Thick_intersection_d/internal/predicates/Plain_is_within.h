// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_PLAIN_IS_WITHIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_PLAIN_IS_WITHIN_H

// Decides whether |pq| <= r as Is_within_distance does, for so few points that what that prepares
// takes longer than their pairs: only a filter is made. It needs no scene. Degree 2.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Doubles must hold the coordinates of the points and the number of the bound.
template <class Point, class NT>
class Plain_is_within
{
  using Exact = Exact_number_t<Coordinate_t<Point>>;
  static constexpr int dimension = dimension_or<Point>(0);

public:
  // The bound must be valid: neither negative nor NaN.
  explicit Plain_is_within(const Distance_bound<NT>& bound) : bound_(bound)
  {
    const double value = static_cast<double>(bound.value());
    const double square = bound.is_squared() ? value : value * value;
    // If the square of a finite number overflows, the filter never says "outside".
    filter_ = is_finite_number(value)
                ? make_distance_filter(square * (1 - 0x1p-50), square * (1 + 0x1p-50), dimension)
                : Distance_filter{value, value};
  }

  const Distance_filter& filter() const { return filter_; }

  // Decides about points that the filter leaves undecided.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool decide_undecided(const Point& p, const Point& q)
  {
    if(const std::optional<double> square = exact_square_in_doubles(p, q))
      if(const double r = static_cast<double>(bound_.value()); bound_.is_squared() || is_short(r)) {
        const double r2 = bound_.is_squared() ? r : r * r;
        return bound_.is_open() ? *square < r2 : *square <= r2;
      }
    if(!exact_bound_)
      exact_bound_.emplace(bound_);
    return exact_bound_->holds_for(exact_squared_distance(p, q, dimension));
  }

private:
  // Whether the square of a double needs no rounding: it has at most 24 bits.
  static bool is_short(double x) { return static_cast<double>(static_cast<float>(x)) == x; }

  // Returns |pq|^2 if doubles compute it without error, as on most lattices. The gap of x and y is
  // exact if both x - gap and gap + y are what they should be, because one of them is not rounded,
  // by Sterbenz. So is a sum, with one of the differences from its terms.
  static std::optional<double> exact_square_in_doubles(const Point& p, const Point& q)
  {
    double sum = 0;
    for(int axis = 0; axis < dimension; ++axis) {
      const double x = static_cast<double>(coordinate(p, axis));
      const double y = static_cast<double>(coordinate(q, axis));
      const double gap = x - y;
      const double square = gap * gap;
      const double next = sum + square;
      if(!is_short(gap) || x - gap != y || gap + y != x || next - sum != square
         || next - square != sum)
        return std::nullopt;
      sum = next;
    }
    return sum;
  }

  const Distance_bound<NT>& bound_;
  Distance_filter filter_;
  std::optional<Squared_bound<Exact>> exact_bound_; // once it was needed
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_PLAIN_IS_WITHIN_H
