// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTEGER_DISTANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTEGER_DISTANCE_H

// Decides whether |pq|^2 <= r^2 in integers, for coordinates that are doubles and multiples of 2^e.
//
// Let U = floor(reach / 2^e), where the reach is at most 2^1022. Points that differ by more than U
// steps along an axis are not within the bound. For all other points, integers hold the differences
// and their squares. The sum of the squares is compared with the number of squared steps in r^2,
// which is computed once, from the exact r^2:
//
// 1. Let fl(|x - y|) be the result of one rounded subtraction. If it is above the reach, then
//    |x - y| is above the reach, because rounding is monotone and fixes the reach (Lemma M,
//    doc/proofs.md). Otherwise let T = |x - y| / 2^e.
// 2. If U < 2^53, then (U + 1) 2^e is a double beyond the reach, so T <= U, again by Lemma M. So
//    |x - y| has at most 53 bits. The subtraction was exact, and the product with 2^-e is exact.
// 3. If 2^53 <= U < 2^63, then T 2^e is below the double after the reach, so T < 2^63. T is the
//    difference of x / 2^e and y / 2^e modulo 2^64, however large these quotients are. Integers
//    compare T with U.
//
// So the decision does not depend on the rounding mode, on a filter, or on the place of the scene.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Square` is an unsigned integer type that holds d U^2 and (U + 1)^2.
template <class Square>
class Integer_distance
{
public:
  // The reach is to be a number of steps that fits_int64() or fits_int128() holds for.
  template <class Exact>
  Integer_distance(const Squared_bound<Exact>& bound, int exponent)
    : reach_(bound.reach()), max_steps_(static_cast<std::uint64_t>(steps_within(reach_, exponent))),
      exponent_(exponent),
      scale_{std::ldexp(1., -exponent / 2), std::ldexp(1., -exponent - (-exponent / 2))},
      beyond_(bound.template first_beyond<Square>(
        exponent, 2 * (std::ilogb(static_cast<double>(max_steps_) + 1) + 1)))
  {}

  // Whether points with coordinates x(i) and y(i) are within the bound.
  template <class X, class Y>
  bool holds_for(const X& x, const Y& y, int dimension) const
  {
    Square sum = 0;
    for(int i = 0; i < dimension; ++i) {
      const double gap = std::fabs(x(i) - y(i));
      if(gap > reach_)
        return false;
      const std::uint64_t steps = steps_between(x(i), y(i), gap);
      if(steps > max_steps_)
        return false;
      sum += Square(steps) * steps;
    }
    return sum < beyond_;
  }

private:
  std::uint64_t steps_between(double x, double y, double gap) const
  {
    if(max_steps_ < std::uint64_t(1) << 53)
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(gap * scale_[0] * scale_[1]));
    const std::uint64_t difference = steps_modulo_2_64(x, exponent_)
                                     - steps_modulo_2_64(y, exponent_);
    return x < y ? 0 - difference : difference;
  }

  double reach_;
  std::uint64_t max_steps_; // U
  int exponent_;
  double scale_[2]; // the product is 2^-e, which itself may be no double
  Square beyond_;   // the least squared distance beyond the bound, in squares of a step
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_INTEGER_DISTANCE_H
