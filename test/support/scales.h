// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers of a kernel on several scales.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SCALES_H
#define THICK_INTERSECTION_TEST_SUPPORT_SCALES_H

#include "standard_library.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;

// What is done to numbers, without rounding. The pairs stay the same.
enum class Scale {
  ONE,
  HUGE_POWER, // squares of such numbers are no doubles, or no integers
  DENORMAL,
  THIRD,      // few of these are doubles, but objects that touched do so still
  CLOSE       // no doubles are between these, so all boxes of doubles meet
};

template <class FT>
constexpr bool can_scale(Scale scale)
{
  return scale == Scale::ONE ? true
         : scale == Scale::THIRD || scale == Scale::CLOSE
           ? std::conjunction_v<std::negation<std::is_arithmetic<FT>>,
                                typename CGAL::Algebraic_structure_traits<FT>::Is_exact>
         : scale == Scale::DENORMAL ? !std::is_same_v<FT, float> && !std::is_integral_v<FT>
                                    : !std::is_same_v<FT, float>;
}

template <class FT>
FT scaled(double x, Scale scale)
{
  if constexpr(internal::Is_quotient<FT>::value) {
    typename FT::NT numerator, denominator;
    CGAL::Fraction_traits<CGAL::Exact_rational>::Decompose()(
      scaled<CGAL::Exact_rational>(x, scale), numerator, denominator);
    return FT(numerator, denominator);
  }
  else {
    if constexpr(can_scale<FT>(Scale::THIRD)) {
      if(scale == Scale::THIRD)
        return FT(FT(x) / FT(3));
      if(scale == Scale::CLOSE)
        return FT(FT(1) + FT(std::ldexp(x, -80)));
    }
    return FT(scale == Scale::HUGE_POWER ? std::ldexp(x, std::is_integral_v<FT> ? 40 : 990)
              : scale == Scale::DENORMAL ? std::ldexp(x, -1074)
                                         : x);
  }
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SCALES_H
