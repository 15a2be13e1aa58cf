// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_IN_INTEGERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_IN_INTEGERS_H

// Decides whether |pq| <= r + s in integers, for coordinates and radii that are doubles.
//
// The numbers of the two balls have a grid 2^e Z of their own. Let S = (r + s) / 2^e < 2^62.
//
// 1. Let fl(|x - y|) be the result of one rounded subtraction. If it is above a double that is at
//    least r + s, then |x - y| is above r + s (Lemma M, doc/proofs.md), so the balls are apart.
// 2. Otherwise T = |x - y| / 2^e is below 2^63, so T is the difference of x / 2^e and y / 2^e
//    modulo 2^64, however large these quotients are. Integers compare T with S.
// 3. Integers of 128 bits hold the sum of up to eight squares of T <= S, and S^2.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DO_BALLS_INTERSECT_IN_INTEGERS_H
