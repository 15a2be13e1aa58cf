// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_CHECK_DENORMALS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_CHECK_DENORMALS_H

// Checks that the processor computes with denormal numbers in the present thread.

#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws if the processor takes denormal results or arguments as zero. Then different coordinates
// would seem equal, and a rounded difference might be within reach though the exact difference is
// not. A library compiled with -ffast-math may have set this for the whole process.
inline void check_denormals()
{
  const volatile double least_normal = (std::numeric_limits<double>::min)();
  const volatile double larger = 1.5 * (std::numeric_limits<double>::min)();
  const volatile double denormal = larger - least_normal; // 0 if results are flushed
  if(!(denormal > 0))                                    // or if arguments are
    throw std::runtime_error(
      "The processor flushes denormal numbers to zero, so differences of coordinates may vanish. "
      "Before the search, call _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF) and "
      "_MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_OFF) on x86, and link without -ffast-math.");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_CHECK_DENORMALS_H
