// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A number type that measures algebraic degree. Each value is an exact rational that knows its
// degree as a polynomial in the input; each comparison and each sign leaves a note of the degree
// that was decided. CGAL::Simple_cartesian<test_support::Degree_number> takes it through any
// algorithm.
//
// A predicate has degree k if it decides on signs of polynomials of degree at most k in the input
// coordinates, a radius being counted as a coordinate. [Liotta, Preparata and Tamassia, Robust
// proximity queries, SIAM J. Comput. 28 (1998)] [V03, section 2]

#ifndef THICK_INTERSECTION_TEST_SUPPORT_DEGREE_NUMBER_H
#define THICK_INTERSECTION_TEST_SUPPORT_DEGREE_NUMBER_H

#include "standard_library.h"

#include <CGAL/Gmpq.h>
#include <CGAL/number_type_basic.h>

#include <istream>

namespace test_support {

// What happened at one call site, or in a whole run.
struct Degree_tally
{
  static constexpr int max_degree = 31; // higher ones are counted here

  std::array<std::uint64_t, max_degree + 1> signs{}; // by degree: how many signs were taken
  std::size_t bits = 0;          // of the longest number that was computed or compared
  int degree_in_doubles = 0;     // the highest degree of a number that was approximated by doubles

  // The highest degree whose sign was taken, 0 if none was.
  int degree() const
  {
    for(int k = max_degree; k > 0; --k)
      if(signs[k] != 0)
        return k;
    return 0;
  }

  void add_sign(int degree, std::size_t number_bits)
  {
    ++signs[(std::min)(degree, max_degree)];
    add_number(number_bits);
  }
  void add_number(std::size_t number_bits) { bits = (std::max)(bits, number_bits); }
};

// Notes what the numbers of type Degree_number go through, for each call site. There is one record
// per process; it is not for several threads.
class Degree_record
{
public:
  static Degree_record& get()
  {
    static Degree_record record;
    return record;
  }

  // Forgets everything. If `hides_doubles`, numbers are approximated by (-infinity, infinity) from
  // now on, so that no filter decides anything and the exact numbers decide all.
  void restart(bool hides_doubles)
  {
    tallies_.clear();
    site_ = &tallies_[""];
    hides_doubles_ = hides_doubles;
  }

  // By call site; "" is the site of whatever has none.
  const std::map<std::string, Degree_tally>& tallies() const { return tallies_; }

  // All call sites together.
  Degree_tally total() const
  {
    Degree_tally sum;
    for(const auto& [site, tally] : tallies_) {
      for(int k = 0; k <= Degree_tally::max_degree; ++k)
        sum.signs[k] += tally.signs[k];
      sum.bits = (std::max)(sum.bits, tally.bits);
      sum.degree_in_doubles = (std::max)(sum.degree_in_doubles, tally.degree_in_doubles);
    }
    return sum;
  }

  Degree_tally& site() { return *site_; }
  bool hides_doubles() const { return hides_doubles_; }

private:
  friend class Call_site;

  Degree_record() { restart(false); }

  std::map<std::string, Degree_tally> tallies_; // whose elements do not move
  Degree_tally* site_;
  bool hides_doubles_ = false;
};

// While it lives, what is noted is noted for the call site of this name. Sites nest.
class Call_site
{
public:
  explicit Call_site(const std::string& name) : outer_(Degree_record::get().site_)
  {
    Degree_record::get().site_ = &Degree_record::get().tallies_[name];
  }
  ~Call_site() { Degree_record::get().site_ = outer_; }
  Call_site(const Call_site&) = delete;
  Call_site& operator=(const Call_site&) = delete;

private:
  Degree_tally* outer_;
};

// A quotient of polynomials in the input, and its value. Constants have degree 0.
class Degree_number
{
public:
  Degree_number() : Degree_number(0) {}
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  Degree_number(Number constant) : value_(to_rational(constant))
  {}
  explicit Degree_number(const CGAL::Gmpq& constant) : value_(constant) {}

  // A coordinate or a radius of the input: degree 1.
  static Degree_number input(double value) { return {CGAL::Gmpq(value), 1, 0}; }

  const CGAL::Gmpq& value() const { return value_; }

  // The degree of the value; of numerator and denominator, the higher one.
  int degree() const { return (std::max)(numerator_, denominator_); }

  // The sign, which counts as taken.
  CGAL::Sign sign() const
  {
    Degree_record::get().site().add_sign(degree(), bits());
    return value_.sign();
  }

  // Doubles that enclose the value.
  std::pair<double, double> to_interval() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Degree_tally& site = Degree_record::get().site();
    site.degree_in_doubles = (std::max)(site.degree_in_doubles, degree());
    if(Degree_record::get().hides_doubles())
      return {-infinity, infinity};
    return CGAL::to_interval(value_);
  }

  Degree_number operator+() const { return *this; }
  Degree_number operator-() const { return {-value_, numerator_, denominator_}; }

  friend Degree_number operator+(const Degree_number& a, const Degree_number& b)
  {
    return {a.value_ + b.value_, degree_of_sum(a, b), a.denominator_ + b.denominator_};
  }
  friend Degree_number operator-(const Degree_number& a, const Degree_number& b)
  {
    return {a.value_ - b.value_, degree_of_sum(a, b), a.denominator_ + b.denominator_};
  }
  friend Degree_number operator*(const Degree_number& a, const Degree_number& b)
  {
    return {a.value_ * b.value_, a.numerator_ + b.numerator_, a.denominator_ + b.denominator_};
  }
  friend Degree_number operator/(const Degree_number& a, const Degree_number& b)
  {
    return {a.value_ / b.value_, a.numerator_ + b.denominator_, a.denominator_ + b.numerator_};
  }

  Degree_number& operator+=(const Degree_number& b) { return *this = *this + b; }
  Degree_number& operator-=(const Degree_number& b) { return *this = *this - b; }
  Degree_number& operator*=(const Degree_number& b) { return *this = *this * b; }
  Degree_number& operator/=(const Degree_number& b) { return *this = *this / b; }

  // Comparing a with b takes the sign of a - b, and both of them have to be held without error.
  friend CGAL::Comparison_result compare(const Degree_number& a, const Degree_number& b)
  {
    const int degree = (std::max)(degree_of_sum(a, b), a.denominator_ + b.denominator_);
    Degree_record::get().site().add_sign(degree, (std::max)(a.bits(), b.bits()));
    return CGAL::compare(a.value_, b.value_);
  }
  friend bool operator==(const Degree_number& a, const Degree_number& b)
  {
    return compare(a, b) == CGAL::EQUAL;
  }
  friend bool operator!=(const Degree_number& a, const Degree_number& b) { return !(a == b); }
  friend bool operator<(const Degree_number& a, const Degree_number& b)
  {
    return compare(a, b) == CGAL::SMALLER;
  }
  friend bool operator>(const Degree_number& a, const Degree_number& b) { return b < a; }
  friend bool operator<=(const Degree_number& a, const Degree_number& b) { return !(b < a); }
  friend bool operator>=(const Degree_number& a, const Degree_number& b) { return !(a < b); }

  friend std::ostream& operator<<(std::ostream& out, const Degree_number& x)
  {
    return out << x.value_;
  }
  friend std::istream& operator>>(std::istream& in, Degree_number& x)
  {
    CGAL::Gmpq value;
    in >> value;
    x = Degree_number(value);
    return in;
  }

private:
  Degree_number(const CGAL::Gmpq& value, int numerator, int denominator)
    : value_(value), numerator_(numerator), denominator_(denominator)
  {
    Degree_record::get().site().add_number(bits());
  }

  template <class Number>
  static CGAL::Gmpq to_rational(Number x)
  {
    if constexpr(std::is_floating_point_v<Number>)
      return CGAL::Gmpq(static_cast<double>(x));
    else if constexpr(std::is_signed_v<Number>)
      return CGAL::Gmpq(static_cast<long>(x));
    else
      return CGAL::Gmpq(static_cast<unsigned long>(x));
  }

  // The degree of the numerator of a + b and a - b.
  static int degree_of_sum(const Degree_number& a, const Degree_number& b)
  {
    return (std::max)(a.numerator_ + b.denominator_, b.numerator_ + a.denominator_);
  }

  // Of an integer, the bits of its absolute value. A denominator is counted as well.
  std::size_t bits() const
  {
    return value_.numerator().bit_size() + value_.denominator().bit_size() - 1;
  }

  CGAL::Gmpq value_;
  int numerator_ = 0; // degrees
  int denominator_ = 0;
};

} // namespace test_support

namespace CGAL {

// An exact field. The package computes with the numbers of an exact field themselves.
template <>
class Algebraic_structure_traits<test_support::Degree_number>
  : public Algebraic_structure_traits_base<test_support::Degree_number, Field_tag>
{
public:
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_false;
};

template <>
class Real_embeddable_traits<test_support::Degree_number>
  : public INTERN_RET::Real_embeddable_traits_base<test_support::Degree_number, Tag_true>
{
public:
  using Type = test_support::Degree_number;

  struct Sgn
  {
    using result_type = Sign;
    Sign operator()(const Type& x) const { return x.sign(); }
  };

  struct Compare
  {
    using result_type = Comparison_result;
    Comparison_result operator()(const Type& a, const Type& b) const { return compare(a, b); }
  };

  struct To_double
  {
    using result_type = double;
    double operator()(const Type& x) const { return CGAL::to_double(x.value()); }
  };

  struct To_interval
  {
    using result_type = std::pair<double, double>;
    std::pair<double, double> operator()(const Type& x) const { return x.to_interval(); }
  };
};

} // namespace CGAL

#endif // THICK_INTERSECTION_TEST_SUPPORT_DEGREE_NUMBER_H
