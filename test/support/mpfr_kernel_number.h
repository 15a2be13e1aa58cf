// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Makes Boost's MPFR numbers of fixed precision usable as the number type of a CGAL kernel:
// CGAL::Simple_cartesian<test_support::Mpfr_number<50>>. CGAL describes only Boost's integers and
// rationals, so what a kernel asks of a rounded number type is added here.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_MPFR_KERNEL_NUMBER_H
#define THICK_INTERSECTION_TEST_SUPPORT_MPFR_KERNEL_NUMBER_H

#include "standard_library.h"

#include <CGAL/boost_mp.h>
#include <CGAL/number_type_basic.h>

#include <boost/multiprecision/mpfr.hpp>

namespace test_support {

// At least this many decimal digits, kept on the stack; no expression templates, which CGAL's
// kernels do not expect as the type of a sum.
template <unsigned Digits>
using Mpfr_number = boost::multiprecision::number<
  boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
  boost::multiprecision::et_off>;

} // namespace test_support

namespace CGAL {

// These are more specialised than CGAL's own, for every number of Boost.Multiprecision.
template <unsigned Digits>
class Algebraic_structure_traits<test_support::Mpfr_number<Digits>>
  : public Algebraic_structure_traits_base<test_support::Mpfr_number<Digits>, Field_with_sqrt_tag>
{
public:
  using Type = test_support::Mpfr_number<Digits>;
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  struct Sqrt
  {
    using result_type = Type;
    Type operator()(const Type& x) const { return boost::multiprecision::sqrt(x); }
  };
};

template <unsigned Digits>
class Real_embeddable_traits<test_support::Mpfr_number<Digits>>
  : public INTERN_RET::Real_embeddable_traits_base<test_support::Mpfr_number<Digits>, Tag_true>
{
public:
  using Type = test_support::Mpfr_number<Digits>;

  struct Is_finite
  {
    using result_type = bool;
    bool operator()(const Type& x) const { return mpfr_number_p(x.backend().data()) != 0; }
  };

  struct To_double
  {
    using result_type = double;
    double operator()(const Type& x) const { return mpfr_get_d(x.backend().data(), MPFR_RNDN); }
  };

  // The two doubles next to x, or x itself if it is one. MPFR rounds as told, whatever the mode of
  // the processor, and stops at the largest double when it rounds an overflow towards zero.
  struct To_interval
  {
    using result_type = std::pair<double, double>;
    std::pair<double, double> operator()(const Type& x) const
    {
      return {mpfr_get_d(x.backend().data(), MPFR_RNDD), mpfr_get_d(x.backend().data(), MPFR_RNDU)};
    }
  };
};

} // namespace CGAL

#endif // THICK_INTERSECTION_TEST_SUPPORT_MPFR_KERNEL_NUMBER_H
