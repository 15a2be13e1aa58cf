// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TWOFOLD_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TWOFOLD_DISTANCE_H

// Compares two distances that are equal or nearly so, by doubles. In a scene of equal steps, nearly
// all distances of neighbors are.

#include <CGAL/Thick_intersection_d/internal/predicates/Twofold_filter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The differences of the coordinates of two points, and their squared distance.
class Twofold_distance
{
public:
  static constexpr int max_dimension = 8;

  // The coordinates are the doubles x(i) and y(i), for i < dimension <= max_dimension.
  template <class X, class Y>
  Twofold_distance(const X& x, const Y& y, int dimension) : dimension_(dimension)
  {
    const auto difference = [&](int i) { return twofold_sum(x(i), -y(i)); };
    square_ = sum_of_squares(difference, dimension);
    for(int i = 0; i < dimension; ++i) {
      gaps_[i] = std::fabs(difference(i).value);
      has_exact_gaps_ = has_exact_gaps_ && is_exact_difference(x(i), y(i));
    }
    std::sort(gaps_.begin(), gaps_.begin() + dimension);
  }

  // Returns a negative number, 0 or a positive number if this distance is less than the other one,
  // equal, or greater. Returns nothing if only exact numbers can tell. For distances of one
  // dimension with squares in the range of Twofold_filter.
  std::optional<int> compare(const Twofold_distance& other) const
  {
    const double excess = (square_.value - other.square_.value)
                          + (square_.rest - other.square_.rest);
    const double slack = 2 * twofold_slack((std::max)(square_.value, other.square_.value),
                                           dimension_);
    if(std::fabs(excess) > slack)
      return excess < 0 ? -1 : 1;
    if(has_exact_gaps_ && other.has_exact_gaps_ && gaps_ == other.gaps_)
      return 0;
    return std::nullopt;
  }

private:
  // By Sterbenz, in every rounding mode.
  static bool is_exact_difference(double x, double y)
  {
    const double a = std::fabs(x), b = std::fabs(y);
    return a == 0 || b == 0
           || (std::signbit(x) == std::signbit(y) && a <= 2 * b && b <= 2 * a);
  }

  int dimension_;
  Twofold square_;
  std::array<double, max_dimension> gaps_ = {}; // sorted
  bool has_exact_gaps_ = true;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TWOFOLD_DISTANCE_H
