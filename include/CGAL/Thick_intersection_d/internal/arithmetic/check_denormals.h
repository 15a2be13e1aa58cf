// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_CHECK_DENORMALS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_CHECK_DENORMALS_H

// Whether the processor, as the present thread has set it up, computes with denormal numbers.

#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if denormal results or arguments are taken as zero: then points would seem to have equal
// coordinates that differ, and a rounded difference might be within reach though the exact one is
// not. A library compiled with -ffast-math may have set this for the whole process.
inline void check_denormals()
{
  const volatile double least_normal = (std::numeric_limits<double>::min)();
  const volatile double denormal = least_normal / 2; // 0 if results are flushed
  if(!(denormal > 0))                                // or if arguments are
    throw std::runtime_error(
      "Denormal numbers are flushed to zero, so that differences of coordinates may vanish: switch "
      "that off before the search, on x86 by _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF) and "
      "_MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_OFF), and link without -ffast-math.");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_CHECK_DENORMALS_H
