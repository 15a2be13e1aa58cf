// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_EXACT_NUMBER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_EXACT_NUMBER_H

// Numbers without error. Converts each number type of the user to a type that computes and compares
// squared distances exactly, and to doubles that enclose the number.

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Quotient.h>
#include <CGAL/number_utils.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/dyadic_numbers.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>

#if defined __FAST_MATH__ || defined _M_FP_FAST \
  || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error "Thick_intersection_d is exact and relies on IEEE 754: compile without -ffast-math."
#endif
// The x87 unit rounds sums and products of doubles to long double first, if they are not stored.
#if FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2
#error "Thick_intersection_d is exact and relies on IEEE 754: compile with -msse2 -mfpmath=sse."
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether a type is that of numbers. A point is none, nor is a range.
template <class T>
inline constexpr bool is_number_v
  = std::is_arithmetic_v<T>
    || !std::is_same_v<typename Algebraic_structure_traits<T>::Algebraic_category, Null_tag>;

// Whether all values of a number type are doubles, without rounding.
template <class NT>
constexpr bool is_held_by_double_v
  = std::is_same_v<NT, double> || std::is_same_v<NT, float>
    || (std::is_integral_v<NT> && sizeof(NT) < sizeof(double));

template <class NT>
struct Is_lazy : std::false_type {};
template <class ET>
struct Is_lazy<Lazy_exact_nt<ET>> : std::true_type {};

template <class NT>
struct Is_quotient : std::false_type {};
template <class Integer>
struct Is_quotient<Quotient<Integer>> : std::true_type {};

// Returns the rational value of a built-in integer of any width.
template <class Integer>
Exact_rational rational_of_integer(Integer x)
{
  if constexpr(is_held_by_double_v<Integer>)
    return Exact_rational(static_cast<double>(x));
  else { // two halves, of which the high one has the sign
    constexpr int bits = 4 * sizeof(Integer);
    using Low = std::conditional_t<bits == 32, std::uint32_t, std::uint64_t>;
    using High = std::conditional_t<(Integer(-1) < Integer(0)), std::make_signed_t<Low>, Low>;
    return rational_of_integer(static_cast<High>(x >> bits)) * rational_power_of_two(bits)
           + rational_of_integer(static_cast<Low>(x));
  }
}

// Returns a big integer or a rational as another such type. All can be written and read as text.
template <class Number, class NT>
Number by_text(const NT& x)
{
  std::stringstream text;
  text << x;
  Number value;
  text >> value;
  return value;
}

// Returns the exact value of x, which must be a rational number.
template <class NT>
Exact_rational to_exact_rational(const NT& x)
{
  if constexpr(std::is_same_v<NT, Exact_rational>)
    return x;
  else if constexpr(std::is_integral_v<NT>)
    return rational_of_integer(x);
  else if constexpr(is_held_by_double_v<NT>)
    return Exact_rational(static_cast<double>(x));
  else if constexpr(floating::Is_floating<NT>::value)
    return rational_of_floating(x);
  else if constexpr(is_dyadic_v<NT>)
    return rational_of_dyadic(x);
  else if constexpr(std::is_same_v<NT, Gmpfr>) { // its operations and texts round
    const auto [integer, exponent] = x.to_integer_exp();
    return to_exact_rational(integer) * rational_power_of_two(static_cast<int>(exponent));
  }
  else if constexpr(Is_lazy<NT>::value)
    return to_exact_rational(CGAL::exact(x));
  else if constexpr(Is_quotient<NT>::value)
    return to_exact_rational(x.numerator()) / to_exact_rational(x.denominator());
  else if constexpr(std::is_constructible_v<Exact_rational, const NT&>)
    return Exact_rational(x);
  else
    return by_text<Exact_rational>(x);
}

// Integers of any length: exact, but they do not hold a bound such as 1.5.
template <class NT>
constexpr bool is_integer_type_v
  = std::is_convertible_v<typename Algebraic_structure_traits<NT>::Algebraic_category,
                          Unique_factorization_domain_tag>;

// Whether numbers of a type that is not built in compute without error, and hold doubles. Quotient
// keeps common divisors, and so grows with each sum.
template <class FT>
struct Is_exact_type
  : std::bool_constant<Algebraic_structure_traits<FT>::Is_exact::value && !Is_quotient<FT>::value
                       && !is_integer_type_v<FT>>
{};

// The type that computes squared distances of points with coordinates of type FT without error, and
// holds every double. It is FT itself if FT is exact and holds doubles. For floats and doubles it
// is a type without the cost of fractions. Traits do not know all types that are built in.
template <class FT>
struct Exact_number
{
  using type = std::conditional_t<
    std::conjunction_v<std::negation<std::is_arithmetic<FT>>, Is_exact_type<FT>>, FT,
    Exact_rational>;
};
#ifdef CGAL_HAS_MPZF
template <>
struct Exact_number<double>
{
  using type = Mpzf;
};
template <>
struct Exact_number<float>
{
  using type = Mpzf;
};
#endif

template <class FT>
using Exact_number_t = typename Exact_number<FT>::type;
using Exact_of_doubles = Exact_number_t<double>;

// Returns x, a coordinate or a radius, in an exact type, which holds it.
template <class Exact, class NT>
decltype(auto) to_exact(const NT& x)
{
  if constexpr(std::is_same_v<Exact, NT>)
    return (x);
  else if constexpr(is_held_by_double_v<NT>)
    return Exact(static_cast<double>(x));
  else
    return Exact(to_exact_rational(x));
}

// Returns the big integer x in another exact type.
template <class Number, class Integer>
Number convert_integer(const Integer& x)
{
  if(x == 0) // the conversion of big integers to Mpzf does not take zero
    return Number(0);
  if constexpr(std::is_constructible_v<Number, const Integer&>)
    return Number(x);
#ifdef CGAL_HAS_MPZF
  else if constexpr(std::is_same_v<Number, Mpzf>)
    return Mpzf(by_text<Gmpz>(x));
#endif
  else
    return by_text<Number>(x);
}

#ifdef CGAL_HAS_MPZF
// Returns doubles that enclose x. Those of CGAL are far apart below the normal numbers, and do not
// always enclose x in other rounding modes than to nearest.
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline std::pair<double, double> bounds_of_mpzf(const Mpzf& x)
{
  const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  std::pair<double, double> interval = CGAL::to_interval(x);
  if(interval.first < -0x1p-1020 || interval.second > 0x1p-1020 || CGAL::is_zero(x))
    return interval;
  interval = bounds_of_mpzf(x * Mpzf(0x1p1000));
  double beyond = -std::numeric_limits<double>::infinity();
  for(double* y : {&interval.first, &interval.second}) {
    const double z = std::ldexp(*y, -1000);
    *y = std::ldexp(z, 1000) == *y ? z : std::nextafter(z, beyond);
    beyond = -beyond;
  }
  return interval;
}
#endif

// Returns doubles that enclose x: inf <= x <= sup.
template <class NT>
std::pair<double, double> bounds(const NT& x)
{
  if constexpr(is_held_by_double_v<NT>) {
    const double value = static_cast<double>(x);
    return {value, value};
  }
#ifdef CGAL_HAS_MPZF
  else if constexpr(std::is_same_v<NT, Mpzf>)
    return bounds_of_mpzf(x);
#endif
  else if constexpr(std::is_arithmetic_v<NT>) { // CGAL knows not all of them, nor all long doubles
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double value = static_cast<double>(x);
    if(std::is_integral_v<NT> ? -0x1p53 < value && value < 0x1p53
                              : static_cast<long double>(value) == static_cast<long double>(x))
      return {value, value};
    return {std::nextafter(value, -infinity), std::nextafter(value, infinity)};
  }
  else if constexpr(std::is_same_v<NT, Gmpzf>) // CGAL's interval of a tiny one does not enclose it
    return bounds(to_exact_rational(x));
  else {
    // If rounding goes down, CGAL takes the largest double for powers of two beyond the doubles.
    const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
    const std::pair<double, double> interval = CGAL::to_interval(x);
    if constexpr(Is_quotient<NT>::value) // infinite if its parts are beyond the doubles
      if(std::isinf(interval.second) || std::isinf(interval.first))
        return CGAL::to_interval(to_exact_rational(x));
    return interval;
  }
}

// Whether a number with these bounds is neither NaN nor infinite. If a number is too large for a
// double, its lower bound is the largest double. The lower bound of infinity is infinity.
inline bool are_bounds_of_finite(const std::pair<double, double>& b)
{
  return b.first <= (std::numeric_limits<double>::max)()
         && b.second >= std::numeric_limits<double>::lowest();
}

template <class NT>
bool is_finite_number(const NT& x)
{
  return are_bounds_of_finite(bounds(x));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_EXACT_NUMBER_H
