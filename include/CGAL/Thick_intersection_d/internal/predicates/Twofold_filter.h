// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TWOFOLD_FILTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TWOFOLD_FILTER_H

// A second filter for coordinates that are doubles. It computes with twice the precision, in sums
// of two doubles. It decides pairs that look like ties but are none, as in a lattice of step 0.1.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>

#include <cmath>

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

// Returns the sum of the squares of difference(i), for i < dimension.
template <class Difference>
Twofold sum_of_squares(const Difference& difference, int dimension)
{
  Twofold sum = {0, 0};
  for(int i = 0; i < dimension; ++i) {
    const Twofold d = difference(i);
    const double square = d.value * d.value;
    const double rest_of_square = std::fma(d.value, d.value, -square) + 2 * d.value * d.rest;
    const Twofold next = twofold_sum(sum.value, square);
    sum = {next.value, sum.rest + next.rest + rest_of_square};
  }
  return sum;
}

// Returns a bound on the error of such a sum and of one comparison with it.
//
// Each coordinate takes less than 16 operations on rests. In any rounding mode, each operation is
// off by a few 2^-104 of the sum. The slack has 2^-96 for each coordinate.
inline double twofold_slack(double sum, int dimension)
{
  return std::ldexp(sum, -96) * (dimension + 8);
}

class Twofold_filter
{
public:
  Twofold_filter() = default; // decides nothing

  template <class Exact>
  CGAL_RARELY_CALLED Twofold_filter(const Squared_bound<Exact>& bound, int dimension)
  {
    const auto& [low, high] = bound.squared();
    if(low > min_twofold_square && high < max_twofold_square) {
      squared_bound_ = {low, bound.excess(low)};
      slack_ = twofold_slack(high, dimension);
    }
  }

  // Whether there is a bound that this filter can decide.
  bool is_usable() const { return slack_ > 0; }

  // Returns a negative number if |pq| is certainly less than r, a positive number if |pq| is
  // certainly greater than r, and 0 otherwise. `difference(i)` is coordinate i of p - q.
  template <class Difference>
  int compare(const Difference& difference, int dimension) const
  {
    const Twofold sum = sum_of_squares(difference, dimension);
    const double excess
      = (sum.value - squared_bound_.value) + (sum.rest - squared_bound_.rest);
    return excess > slack_ ? 1 : excess < -slack_ ? -1 : 0;
  }

private:
  Twofold squared_bound_ = {0, 0};
  double slack_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_TWOFOLD_FILTER_H
