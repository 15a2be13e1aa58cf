// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_EXACT_TIER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_EXACT_TIER_H

// Chooses the arithmetic that is exact for points on a grid 2^e Z: for squared distances, and for
// determinants of differences.
//
// Of squared distances, only differences up to the reach matter: points farther apart are beyond
// the bound, and each arithmetic finds this out safely. A difference up to the reach has at most U
// = floor(reach / 2^e) steps.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns U, or infinity if U is no double.
inline double steps_within(double reach, int grid_exponent)
{
  return std::floor(std::ldexp(reach, -grid_exponent));
}

// The same, or infinity if there is no grid.
inline double steps_within(double reach, const std::optional<int>& grid_exponent)
{
  return grid_exponent ? steps_within(reach, *grid_exponent)
                       : std::numeric_limits<double>::infinity();
}

// Returns how many squares a sum counts as: at least 2, so the square of U + 1 is exact as well.
inline int square_terms(int axis_count) { return (std::max)(axis_count, 2); }

// The certificate: returns whether doubles compute all squared distances up to the reach without
// error.
//
// If so, a sum of `axis_count` squares of U steps has at most 53 bits, and does not underflow or
// overflow. A longer difference has at least U + 1 steps, and its square is beyond the bound.
// Rounding is monotone, so the computed sum is beyond the bound as well (doc/arithmetic.md).
inline bool are_squares_exact_in_double(double reach, int grid_exponent, int axis_count)
{
  const double steps = steps_within(reach, grid_exponent);
  return 2 * grid_exponent >= -1074 && reach <= 0x1p500
         && square_terms(axis_count) * steps * steps <= 0x1p53;
}

// Whether d U^2 <= max_sum. `steps` is an integer, or infinity.
inline bool are_squares_at_most(const Uint128& max_sum, double steps, int axis_count)
{
  if(!(steps < 0x1p63))
    return false;
  const Uint128 u = static_cast<std::uint64_t>(steps);
  return u * u <= max_sum / static_cast<unsigned int>((std::max)(axis_count, 1));
}

// Whether sums of squares fit into integers of 64 bits, even into signed ones.
inline bool fits_int64(double steps, int axis_count)
{
  return are_squares_at_most((std::numeric_limits<std::int64_t>::max)(), steps, axis_count);
}

inline bool fits_int128(double steps, int axis_count)
{
  return are_squares_at_most(~Uint128(0), steps, axis_count);
}

// Returns the exponent of the finest grid that fits_int128() holds for, or of that of all doubles.
inline int finest_grid_exponent(double reach, int axis_count)
{
  int e = std::ilogb((std::max)(reach, 0x1p-1012)) - 62;
  while(!fits_int128(steps_within(reach, e), axis_count))
    ++e;
  return e;
}

// Returns the first tier that is exact for points that differ along `axis_count` axes. It is the
// last tier if there is no grid, or if the reach is so large that differences may overflow.
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline Arithmetic_tier first_exact_tier(double reach, const std::optional<int>& grid_exponent,
                                        int axis_count)
{
  if(!grid_exponent || reach > 0x1p1022)
    return Arithmetic_tier::FILTERED_EXACT;
  if(are_squares_exact_in_double(reach, *grid_exponent, axis_count))
    return Arithmetic_tier::DOUBLE;
  const double steps = steps_within(reach, *grid_exponent);
  if(fits_int64(steps, axis_count))
    return Arithmetic_tier::INT64;
  if(fits_int128(steps, axis_count))
    return Arithmetic_tier::INT128;
  return Arithmetic_tier::FILTERED_EXACT;
}

// ---- determinants -------------------------------------------------------------------------------

// Returns the least m such that a difference of at most `reach` is below 2^m steps of the grid.
inline int difference_bits(double reach, int grid_exponent)
{
  const double steps = steps_within(reach, grid_exponent);
  return steps < 1 ? 0 : steps < 0x1p1000 ? std::ilogb(steps) + 1 : 1001;
}

// Returns how many bits the terms of a determinant and their sums have, besides a sign: there are
// two terms in the plane, six in space, and a difference is a determinant of one term.
inline int determinant_bits(const std::vector<double>& reaches, int grid_exponent, int degree)
{
  int bits = degree == 3 ? 3 : degree - 1;
  for(std::size_t axis = 0; axis < reaches.size(); ++axis)
    bits = degree == 1 ? (std::max)(bits, difference_bits(reaches[axis], grid_exponent))
                       : bits + difference_bits(reaches[axis], grid_exponent);
  return bits;
}

// Returns the first tier that is exact for the determinants of differences up to the reach of each
// axis. Comparisons, of degree 1, are exact in doubles. Determinants are so if their terms have at
// most 53 bits and do not underflow or overflow. Integers take differences of max_step_bits.
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline Arithmetic_tier first_exact_tier(const std::vector<double>& reaches,
                                        const std::optional<int>& grid_exponent, int degree)
{
  if(degree == 1)
    return Arithmetic_tier::DOUBLE;
  if(!grid_exponent)
    return Arithmetic_tier::FILTERED_EXACT;
  const int e = *grid_exponent;
  for(const double reach : reaches)
    if(difference_bits(reach, e) > max_step_bits)
      return Arithmetic_tier::FILTERED_EXACT;
  const int bits = determinant_bits(reaches, e, degree);
  if(bits <= 53 && degree * e >= -1074 && degree * e + 53 < 1023)
    return Arithmetic_tier::DOUBLE;
  return bits < 64    ? Arithmetic_tier::INT64
         : bits < 128 ? Arithmetic_tier::INT128
                      : Arithmetic_tier::INT192;
}

// ---- distances of objects -----------------------------------------------------------------------

// Returns how many bits the parts of squared distances of objects have, besides a sign, if their
// degree is 2, 4 or 6 and differences are at most `reach`.
inline int distance_bits(double reach, int grid_exponent, int degree)
{
  return degree * difference_bits(reach, grid_exponent) + (degree == 6 ? 6 : 3);
}

// Returns the first tier that is exact for them: integers of 128 bits or exact numbers.
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline Arithmetic_tier first_distance_tier(double reach, const std::optional<int>& grid_exponent,
                                           int degree)
{
  return grid_exponent && distance_bits(reach, *grid_exponent, degree) < 120
           ? Arithmetic_tier::INT128 : Arithmetic_tier::FILTERED_EXACT;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_EXACT_TIER_H
