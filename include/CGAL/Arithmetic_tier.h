// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_ARITHMETIC_TIER_H
#define CGAL_ARITHMETIC_TIER_H

// The kinds of arithmetic that decide whether a pair of points is within a bound, or whether two
// objects intersect.

#include <ostream>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

names the arithmetic that decides whether a pair of points is within a bound, or whether two objects
intersect. Each tier gives the exact answer for its scenes. A tier suffices for all scenes that an
earlier tier suffices for.
*/
enum class Arithmetic_tier {
  DOUBLE,          ///< Doubles compute all squared distances near the bound, or all determinants,
                   ///< without rounding.
  INT64,           ///< Doubles decide what they safely can, integers of 64 bits decide the rest.
  INT128,          ///< Doubles decide what they safely can, integers of 128 bits decide the rest.
  INT192,          ///< Doubles decide what they safely can, integers of 192 bits decide the rest.
                   ///< Objects in space may need them; for points they are no better than
                   ///< `FILTERED_EXACT`, which then takes their place.
  FILTERED_EXACT   ///< Doubles decide what they safely can, exact numbers decide the rest. Integers
                   ///< decide where they happen to suffice, unless this tier is forced.
};

/// \ingroup PkgThickIntersectionDRef
/// prints `tier` in words.
inline std::ostream& operator<<(std::ostream& out, Arithmetic_tier tier)
{
  switch(tier) {
  case Arithmetic_tier::DOUBLE: return out << "double";
  case Arithmetic_tier::INT64: return out << "int64";
  case Arithmetic_tier::INT128: return out << "int128";
  case Arithmetic_tier::INT192: return out << "int192";
  default: return out << "filter + exact";
  }
}

} // namespace CGAL

#endif // CGAL_ARITHMETIC_TIER_H
