// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Predicates in rounded arithmetic of more and more bits, against the same polynomial in integers.

#ifndef THICK_INTERSECTION_BENCHMARK_LABORATORY_STAIRCASE_H
#define THICK_INTERSECTION_BENCHMARK_LABORATORY_STAIRCASE_H

#include "near_degenerate.h"

#include "support/mpfr_kernel_number.h"

#include <boost/multiprecision/gmp.hpp>

#include <utility>
#include <vector>

namespace lab {

using Exact_integer = boost::multiprecision::number<boost::multiprecision::gmp_int,
                                                    boost::multiprecision::et_off>;

// Boost counts decimal digits; these give 11 to 131 bits.
using Precisions = std::integer_sequence<unsigned, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16,
                                         17, 18, 19, 20, 22, 24, 26, 28, 30, 31, 32, 33, 34, 35, 36,
                                         37, 38, 39>;

// Up to 157 bits.
using Long_precisions
  = std::integer_sequence<unsigned, 3, 5, 7, 9, 11, 13, 15, 16, 17, 18, 20, 22, 24, 26, 28, 30, 32,
                          34, 36, 38, 40, 42, 44, 45, 47>;

// How many bits a number of so many digits has.
template <unsigned Digits>
int bits_of()
{
  return static_cast<int>(
    mpfr_get_prec(test_support::Mpfr_number<Digits>(1).backend().data()));
}

template <class Number>
std::vector<Number> in_numbers(const Question& question)
{
  std::vector<Number> v;
  for(double x : question)
    v.push_back(Number(x)); // rounded if the number has too few bits
  return v;
}

// Questions of one predicate and the right answers to them.
template <class Predicate>
class Questions
{
public:
  Questions(int bits, bool is_near, std::size_t count)
  {
    Question_generator generator(bits, 7 * bits + is_near);
    for(std::size_t i = 0; i < count; ++i) {
      const Question near = generator.near(Predicate());
      questions_.push_back(is_near ? near : generator.uniform(near.size()));
      answers_.push_back(Predicate::sign(in_numbers<Exact_integer>(questions_.back())));
    }
  }

  std::size_t size() const { return questions_.size(); }

  // How many answers differ when Number computes them.
  template <class Number>
  std::size_t wrong() const
  {
    std::size_t count = 0;
    for(std::size_t i = 0; i < questions_.size(); ++i)
      count += Predicate::sign(in_numbers<Number>(questions_[i])) != answers_[i];
    return count;
  }

private:
  std::vector<Question> questions_;
  std::vector<int> answers_;
};

// Calls f(p, wrong) for each precision of p bits.
template <class Predicate, class Function, unsigned... Digits>
void for_each_precision(const Questions<Predicate>& questions, const Function& f,
                        std::integer_sequence<unsigned, Digits...>)
{
  (f(bits_of<Digits>(), questions.template wrong<test_support::Mpfr_number<Digits>>()), ...);
}

} // namespace lab

#endif // THICK_INTERSECTION_BENCHMARK_LABORATORY_STAIRCASE_H
