// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_SQUARED_BOUND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_SQUARED_BOUND_H

// A checked distance bound in the forms that searches need: its square as an exact number and
// between two doubles, and the reach along an axis.

#include <CGAL/Distance_bound.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Sets the fraction `numerator / denominator` of an exact type to the rational r2.
template <class Exact>
void decompose(const Exact_rational& r2, Exact& numerator, Exact& denominator)
{
  if constexpr(std::is_same_v<Exact, Exact_rational> || Is_lazy<Exact>::value) {
    numerator = Exact(r2);
    denominator = Exact(1);
  }
  else {
    using Fraction = Fraction_traits<Exact_rational>;
    typename Fraction::Numerator_type n;
    typename Fraction::Denominator_type d;
    typename Fraction::Decompose()(r2, n, d);
    numerator = convert_integer<Exact>(n);
    denominator = convert_integer<Exact>(d);
  }
}

// The bound |pq|^2 <= r^2, or |pq|^2 < r^2 if it is open. |pq|^2 has the type Exact.
template <class Exact>
class Squared_bound
{
public:
  // Throws std::invalid_argument if the bound is negative or NaN.
  template <class NT>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED explicit Squared_bound(const Distance_bound<NT>& bound)
    : open_(bound.is_open()), unbounded_(!is_finite_number(bound.value()))
  {
    if(!(bound.value() >= NT(0)))
      throw std::invalid_argument("The distance bound is negative or NaN.");
    if(unbounded_)
      return;

    if constexpr(Is_lazy<NT>::value)
      CGAL::exact(bound.value()); // narrows its interval, which may be as wide as the scene
    if constexpr(std::is_same_v<NT, Exact>)
      numerator_ = square_of(bound.value(), bound.is_squared());
    else if constexpr(is_held_by_double_v<NT>) // which Exact holds as well
      numerator_ = square_of(Exact(static_cast<double>(bound.value())), bound.is_squared());
    else
      decompose(square_of(to_exact_rational(bound.value()), bound.is_squared()),
                numerator_, denominator_);

    const std::pair<double, double> value = bounds(bound.value());
    set_doubles(value, bound.is_squared());
    if constexpr(!is_held_by_double_v<NT>)
      if(bound.is_squared() && (value.second < 0x1p-600 || value.second > 0x1p600)) {
        if constexpr(std::is_same_v<NT, Exact> && !Is_lazy<NT>::value)
          set_reach(bound.value());
        else // products of lazy numbers that are beyond the doubles have no bounds
          set_reach(to_exact_rational(bound.value()));
      }
  }

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Squared_bound(const Squared_bound&) = default;
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED ~Squared_bound() = default;

  bool is_open() const { return open_; }

  // Whether every pair of points is within the bound.
  bool is_unbounded() const { return unbounded_; }

  // Whether r is zero.
  bool is_zero() const { return !unbounded_ && numerator_ == Exact(0); }

  // Doubles that enclose r^2.
  const std::pair<double, double>& squared() const { return squared_; }

  // An upper bound on |x_i(p) - x_i(q)| over the pairs within the bound.
  double reach() const { return reach_; }

  // Whether a squared distance is within the bound. Degree 2 in the coordinates and r.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED bool holds_for(const Exact& squared_distance) const
  {
    if(unbounded_)
      return true;
    const Exact scaled = squared_distance * denominator_;
    return open_ ? scaled < numerator_ : scaled <= numerator_;
  }

  // Whether a squared distance is within (r + s)^2. It is a quotient x = n / d, where d > 0.
  //
  // This is so iff x - r^2 - s^2 is at most 2rs, which is not negative. So its square decides, if
  // it is positive. This takes twice the degree, so not if r or s is zero.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  bool holds_for(const Exact& n, const Exact& d, const Exact& s) const
  {
    if(unbounded_)
      return true;
    const Exact excess(n * denominator_ - d * numerator_ - d * denominator_ * s * s);
    if(excess < Exact(0) || s == Exact(0) || numerator_ == Exact(0))
      return open_ ? excess < Exact(0) : excess <= Exact(0);
    const Exact square(excess * excess);
    const Exact limit(Exact(4) * s * s * d * d * numerator_ * denominator_);
    return open_ ? square < limit : square <= limit;
  }

  // Returns the largest squared distance within the bound that is a double.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED double largest_double() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double threshold = (std::min)(squared_.first, (std::numeric_limits<double>::max)());
    while(!holds_for(Exact(threshold)))
      threshold = std::nextafter(threshold, -infinity);
    for(double next = std::nextafter(threshold, infinity);
        next != infinity && holds_for(Exact(next)); next = std::nextafter(next, infinity))
      threshold = next;
    return threshold;
  }

  // Returns the least integer s such that the squared distance s 4^e is not within the bound. The
  // reach must have fewer than 2^63 steps of 2^e. Divides r^2 by 4^e, bit by bit.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED Uint128 first_beyond(int e) const
  {
    const Exact unit(std::ldexp(1., e));
    const Exact divisor(unit * unit * denominator_);
    Exact rest(numerator_);
    Uint128 quotient = 0;
    for(int bit = 2 * std::ilogb(steps_within(reach_, e) + 1) + 1; bit >= 0; --bit) {
      const Exact part(divisor * Exact(std::ldexp(1., bit)));
      if(part <= rest) {
        rest -= part;
        quotient += Uint128(1) << bit;
      }
    }
    return open_ && rest == Exact(0) ? quotient : Uint128(quotient + 1);
  }

private:
  template <class Number>
  static Number square_of(const Number& value, bool is_squared)
  {
    return is_squared ? value : Number(value * value);
  }

  // Computes with one rounding, to either side. So the neighboring doubles enclose the results.
  void set_doubles(const std::pair<double, double>& value, bool is_squared)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double low = (std::max)(value.first, 0.);
    if(is_squared) {
      squared_ = {low, value.second};
      reach_ = std::nextafter(std::sqrt(value.second), infinity);
    }
    else {
      squared_ = {(std::max)(std::nextafter(low * low, -infinity), 0.),
                  std::nextafter(value.second * value.second, infinity)};
      reach_ = value.second;
    }
  }

  // Sets the reach from r^2, which may be beyond the range of doubles while r is not.
  template <class Number>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void set_reach(Number square)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr int step = 256;
    int exponent = 0; // of the power of four that the square has been divided by
    for(; exponent > -5 * step && bounds(square).second < 0x1p-600; exponent -= step)
      square = square * Number(std::ldexp(1., 2 * step));
    for(; exponent < 5 * step && bounds(square).second > 0x1p600; exponent += step)
      square = square * Number(std::ldexp(1., -2 * step));
    const double root = std::nextafter(std::sqrt(bounds(square).second), infinity);
    reach_ = std::nextafter(std::ldexp(root, exponent), infinity);
  }

  Exact numerator_ = Exact(0);
  Exact denominator_ = Exact(1);
  std::pair<double, double> squared_ = {std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::infinity()};
  double reach_ = std::numeric_limits<double>::infinity();
  bool open_;
  bool unbounded_;
};

#ifdef CGAL_THICK_INTERSECTION_D_COMPILED
extern template class Squared_bound<Exact_of_doubles>;
extern template Squared_bound<Exact_of_doubles>::Squared_bound(const Distance_bound<double>&);
extern template Squared_bound<Exact_of_doubles>::Squared_bound(
  const Distance_bound<Exact_of_doubles>&);
#endif

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_SQUARED_BOUND_H
