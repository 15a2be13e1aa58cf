// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TWOFOLD_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TWOFOLD_DISTANCE_H

// Compares two distances that are equal or nearly so, by doubles of twice the precision. In a scene
// of equal steps, nearly all distances of neighbors are.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The unevaluated sum of two doubles. The second one is small against the first one.
struct Twofold
{
  double value;
  double rest;
};

// Returns a + b. In rounding to nearest the rest is exactly what rounding lost. In the directed
// modes the rest is off by a few 2^-104 of the sum: if a + b is rounded at all, it is at least half
// as long as the longer one of a and b, and each operation on the rest is off by 2^-52 of the rest.
inline Twofold twofold_sum(double a, double b)
{
  const double sum = a + b;
  const double b_in_sum = sum - a;
  return {sum, (a - (sum - b_in_sum)) + (b - b_in_sum)};
}

// Above the one, no part of a product underflows. Up to the other, no sum overflows.
inline constexpr double min_twofold_square = 0x1p-800;
inline constexpr double max_twofold_square = 0x1p1000;

// Returns a bound on the error of a sum of squares and of one comparison with it.
//
// Each coordinate takes less than 16 operations on rests. In any rounding mode, each operation is
// off by a few 2^-104 of the sum. The slack has 2^-96 for each coordinate.
inline double twofold_slack(double sum, int dimension)
{
  return std::ldexp(sum, -96) * (dimension + 8);
}

// The differences of the coordinates of two points, and their squared distance.
class Twofold_distance
{
public:
  static constexpr int max_dimension = 8;

  // The coordinates are the doubles x(i) and y(i), for i < dimension <= max_dimension. Squares are
  // those of differences times `scale`, a power of two.
  template <class X, class Y>
  Twofold_distance(const X& x, const Y& y, int dimension, double scale = 1)
    : dimension_(dimension), scale_(scale)
  {
    for(int i = 0; i < dimension; ++i) {
      differences_[i] = twofold_sum(x(i), -y(i));
      gaps_[i] = std::fabs(differences_[i].value);
      if(gaps_[i] >= (std::numeric_limits<double>::max)()) // may be less than the difference
        differences_[i].rest = std::numeric_limits<double>::quiet_NaN();
      has_exact_gaps_ = has_exact_gaps_ && is_exact_difference(x(i), y(i));
    }
    std::sort(gaps_.begin(), gaps_.begin() + dimension);
  }

  // Returns a negative number, 0 or a positive number if this distance is less than the other one,
  // equal, or greater. Returns nothing if only exact numbers can tell, or a difference overflows.
  // For distances of one dimension and scale, with scaled squares between min_twofold_square and
  // max_twofold_square.
  std::optional<int> compare(const Twofold_distance& other) const
  {
    if(has_exact_gaps_ && other.has_exact_gaps_)
      if(const std::optional<int> order = compare_gaps(other))
        return order;
    const Twofold a = square(), b = other.square();
    const double excess = (a.value - b.value) + (a.rest - b.rest);
    const double slack = 2 * twofold_slack((std::max)(a.value, b.value), dimension_);
    if(std::fabs(excess) > slack)
      return excess < 0 ? -1 : 1;
    return std::nullopt;
  }

private:
  // Decides if no gap of one distance is longer than that of the other. It takes no squares: those
  // of short gaps may be lost in doubles.
  std::optional<int> compare_gaps(const Twofold_distance& other) const
  {
    bool is_shorter = false, is_longer = false;
    for(int i = 0; i < dimension_; ++i) {
      is_shorter = is_shorter || gaps_[i] < other.gaps_[i];
      is_longer = is_longer || gaps_[i] > other.gaps_[i];
    }
    if(is_shorter && is_longer)
      return std::nullopt;
    return is_longer - is_shorter;
  }

  Twofold square() const
  {
    Twofold sum = {0, 0};
    for(int i = 0; i < dimension_; ++i) {
      const Twofold d = {differences_[i].value * scale_, differences_[i].rest * scale_};
      const double square = d.value * d.value;
      const double rest_of_square = std::fma(d.value, d.value, -square) + 2 * d.value * d.rest;
      const Twofold next = twofold_sum(sum.value, square);
      sum = {next.value, sum.rest + next.rest + rest_of_square};
    }
    return sum;
  }

  // By Sterbenz, in every rounding mode.
  static bool is_exact_difference(double x, double y)
  {
    const double a = std::fabs(x), b = std::fabs(y);
    return a == 0 || b == 0
           || (std::signbit(x) == std::signbit(y) && a <= 2 * b && b <= 2 * a);
  }

  int dimension_;
  double scale_;
  std::array<Twofold, max_dimension> differences_;
  std::array<double, max_dimension> gaps_ = {}; // sorted
  bool has_exact_gaps_ = true;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TWOFOLD_DISTANCE_H
