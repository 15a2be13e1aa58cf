// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTEGER_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTEGER_DISTANCE_H

// Decides whether |pq|^2 <= r^2 in integers, for coordinates that are doubles. So it decides the
// near ties of a filter.
//
// Coordinates are counted in steps of a grid 2^e Z. Let U = floor(reach / 2^e), where the reach is
// at most 2^1022. Points that differ by more than U steps along an axis are not within the bound.
// For all other points, integers hold the differences and their squares. The sum of the squares is
// compared with the number of squared steps in r^2, which is computed once, from the exact r^2:
//
// 1. Let fl(|x - y|) be the result of one rounded subtraction. If it is above the reach, then
//    |x - y| is above the reach, because rounding is monotone and fixes the reach (Lemma M,
//    doc/proofs.md). Otherwise let T = |x - y| / 2^e.
// 2. If x and y are on the grid and U < 2^53, then (U + 1) 2^e is a double beyond the reach, so
//    T <= U, again by Lemma M. So |x - y| has at most 53 bits. The subtraction was exact, and the
//    product with 2^-e is exact.
// 3. If fl(|x - y|) is no longer than x and y, then |x - y| has at most 53 bits from the last bit
//    of the shorter of x and y on, so the subtraction was exact as well. Then x - y is on the grid
//    if the product with 2^-e, without its fraction, times 2^e is fl(|x - y|).
// 4. Otherwise, if x and y are on the grid and U < 2^63, then T 2^e is below the double after the
//    reach, so T < 2^63. T is the difference of x / 2^e and y / 2^e modulo 2^64, however large
//    these quotients are. Integers compare T with U.
//
// So the decision does not depend on the rounding mode, on a filter, or on the place of the scene.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Integer_distance
{
public:
  // `tier` is INT64 for points on the grid 2^e Z whose squares fits_int64() holds for, and INT128
  // for all points; fits_int128() must hold for the squares of steps within the reach.
  template <class Exact>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Integer_distance(const Squared_bound<Exact>& bound, int exponent, Arithmetic_tier tier)
    : reach_(bound.reach()), max_steps_(static_cast<std::uint64_t>(steps_within(reach_, exponent))),
      exponent_(exponent),
      scale_{std::ldexp(1., -exponent / 2), std::ldexp(1., -exponent - (-exponent / 2))},
      unit_{1 / scale_[0], 1 / scale_[1]}, beyond_(bound.first_beyond(exponent)),
      takes_64_bits_(tier == Arithmetic_tier::INT64)
  {}

  Arithmetic_tier tier() const
  {
    return takes_64_bits_ ? Arithmetic_tier::INT64 : Arithmetic_tier::INT128;
  }

  // Returns whether points with coordinates x(i) and y(i) are within the bound. Returns nothing if
  // they are not on the grid.
  template <class X, class Y>
  std::optional<bool> decide(const X& x, const Y& y, int dimension) const
  {
    return takes_64_bits_ ? decide_in<std::uint64_t>(x, y, dimension)
                          : decide_in<Uint128>(x, y, dimension);
  }

private:
  template <class Square, class X, class Y>
  std::optional<bool> decide_in(const X& x, const Y& y, int dimension) const
  {
    constexpr bool are_on_grid = std::is_same_v<Square, std::uint64_t>;
    Square sum = 0;
    double lost = 0;
    for(int i = 0; i < dimension; ++i) {
      const double a = x(i), b = y(i);
      const double gap = std::fabs(a - b);
      if(gap > reach_)
        return false;
      std::uint64_t steps = 0;
      if(are_on_grid || gap <= (std::min)(std::fabs(a), std::fabs(b))) {
        const auto integer = static_cast<std::int64_t>(gap * scale_[0] * scale_[1]);
        if constexpr(!are_on_grid)
          lost += std::fabs(static_cast<double>(integer) * unit_[0] * unit_[1] - gap);
        steps = static_cast<std::uint64_t>(integer);
      }
      else if(!count_steps(a, b, steps))
        return std::nullopt;
      else if(steps > max_steps_)
        return false;
      sum += Square(steps) * steps;
    }
    if(lost != 0)
      return std::nullopt;
    return sum < beyond_;
  }

  // Sets `steps` to |x - y| in steps. Returns false if x or y is not on the grid.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  bool count_steps(double x, double y, std::uint64_t& steps) const
  {
    const std::uint64_t difference = steps_modulo_2_64(x, exponent_)
                                     - steps_modulo_2_64(y, exponent_);
    steps = x < y ? 0 - difference : difference;
    const Double_grid grid(exponent_);
    return grid.holds(x) && grid.holds(y);
  }

  double reach_;
  std::uint64_t max_steps_; // U
  int exponent_;
  double scale_[2]; // the product is 2^-e, which itself may be no double
  double unit_[2];  // the product is 2^e
  Uint128 beyond_;  // the least squared distance beyond the bound, in squares of a step
  bool takes_64_bits_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTEGER_DISTANCE_H
