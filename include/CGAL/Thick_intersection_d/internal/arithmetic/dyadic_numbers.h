// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DYADIC_NUMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DYADIC_NUMBERS_H

// Numbers that are integers times powers of two, as rational numbers.

#include <CGAL/Exact_rational.h>
#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {

class Gmpfr;
class Gmpzf;
class MP_Float;

namespace Thick_intersection_d {
namespace internal {

inline Exact_rational rational_power_of_two(int exponent)
{
  if(std::abs(exponent) <= 1000)
    return Exact_rational(std::ldexp(1., exponent));
  const Exact_rational root = rational_power_of_two(exponent / 2);
  return root * root * rational_power_of_two(exponent % 2);
}

// Finds floating-point numbers of any precision by their functions: those of the standard library,
// or by argument-dependent lookup.
namespace floating {
using std::frexp;
using std::ldexp;

template <class NT, class = void>
struct Is_floating : std::is_floating_point<NT> {};
template <class NT>
struct Is_floating<NT, std::void_t<decltype(frexp(std::declval<const NT&>(),
                                                  std::declval<int*>()))>>
  : std::bool_constant<!std::is_integral_v<NT>> {};

// Splits x into a mantissa in [1/2, 1) and an exponent.
template <class NT>
NT mantissa(const NT& x, int& exponent)
{
  return frexp(x, &exponent);
}
} // namespace floating

// Returns the rational value of a finite floating-point number of any precision. Takes the leading
// 53 bits off the mantissa, and makes the rest a mantissa again, until no bits are left. Nothing is
// rounded.
template <class NT>
Exact_rational rational_of_floating(const NT& x)
{
  static_assert(std::numeric_limits<NT>::radix != 10,
                "Decimal floating-point numbers are not taken: pass rational numbers.");
  Exact_rational value(0);
  NT rest = x;
  int exponent = 0; // invariant: x = value + rest * 2^exponent
  while(rest != NT(0)) {
    int shift = 0;
    rest = floating::mantissa(rest, shift);
    exponent += shift;
    const double head = static_cast<double>(rest);
    value += Exact_rational(head) * rational_power_of_two(exponent);
    rest -= NT(head);
  }
  return value;
}

// Whether a type is one of those of CGAL whose numbers are written as doubles, and are no doubles.
template <class NT>
inline constexpr bool is_dyadic_v = std::is_same_v<NT, MP_Float> || std::is_same_v<NT, Gmpzf>;
#ifdef CGAL_HAS_MPZF
template <>
inline constexpr bool is_dyadic_v<Mpzf> = true;
#endif

// Returns the rational value of such a number. Takes doubles off it until nothing is left.
template <class NT>
Exact_rational rational_of_dyadic(const NT& x)
{
  Exact_rational value(0);
  NT rest = x;
  int exponent = 0; // invariant: x = value + rest * 2^exponent
  while(rest != NT(0)) {
    const double head = CGAL::to_double(rest);
    const bool is_large = !(std::fabs(head) < 0x1p900);
    if(is_large || std::fabs(head) < 0x1p-900) { // the double may be far from the number
      rest = rest * NT(is_large ? 0x1p-600 : 0x1p600);
      exponent += is_large ? 600 : -600;
    }
    else {
      value += Exact_rational(head) * rational_power_of_two(exponent);
      rest = rest - NT(head);
    }
  }
  return value;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DYADIC_NUMBERS_H
