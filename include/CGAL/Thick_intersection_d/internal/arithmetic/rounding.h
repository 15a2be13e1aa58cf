// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_ROUNDING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_ROUNDING_H

// Whether the processor rounds to nearest in the present thread.

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Takes two additions, where a call of std::fegetround() would take as long as a few comparisons of
// points. Compilers must not compute them ahead of time.
inline bool rounds_to_nearest()
{
  const volatile double least = 0x1p-60;
  const double x = least;
  return 1 + x == 1 - x;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_ROUNDING_H
