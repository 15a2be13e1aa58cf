// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Signs of determinants against integers of any length, up to the most bits that they take.

#include "support/unit_test.h"

#include <CGAL/Thick_intersection_d/internal/arithmetic/determinant_signs.h>

#include <boost/multiprecision/cpp_int.hpp>

BOOST_AUTO_TEST_SUITE(determinant_signs)

using namespace test_support;
using Integer = boost::multiprecision::cpp_int;
using internal::Int128;

using Vector = std::array<std::int64_t, 3>;

// Of up to `bits` bits, and often the least or the greatest of them.
std::int64_t draw(Random& random, int bits)
{
  const std::int64_t greatest = (std::int64_t(1) << bits) - 1;
  const auto between = static_cast<std::int64_t>(random.below(2 * std::size_t(greatest)));
  const std::size_t kind = random.below(6);
  return kind == 0 ? greatest : kind == 1 ? -greatest : between - greatest;
}

// The third vector is often a sum of the others, or nearly so.
std::array<Vector, 3> draw_vectors(Random& random, int bits)
{
  std::array<Vector, 3> v;
  for(std::size_t k = 0; k < 3; ++k)
    for(std::size_t i = 0; i < 3; ++i)
      v[k][i] = draw(random, k == 2 || random.below(2) == 0 ? bits : bits - 1);
  if(random.below(2) == 0)
    for(std::size_t i = 0; i < 3; ++i)
      v[2][i] = v[0][i] / 2 + v[1][i] / 2 + (random.below(4) == 0);
  return v;
}

int sign(const Integer& x) { return x.sign(); }

Integer minor(const Vector& u, const Vector& v, std::size_t i, std::size_t j)
{
  return Integer(u[i]) * v[j] - Integer(u[j]) * v[i];
}

int expected_sign(const std::array<Vector, 3>& v)
{
  return sign(Integer(minor(v[0], v[1], 1, 2) * v[2][0] + minor(v[0], v[1], 2, 0) * v[2][1]
                      + minor(v[0], v[1], 0, 1) * v[2][2]));
}

template <class Function>
void check(int bits, const Function& sign_of)
{
  Random random(static_cast<unsigned int>(bits));
  std::size_t wrong = 0, zero = 0;
  for(int i = 0; i < 20000; ++i) {
    const std::array<Vector, 3> v = draw_vectors(random, bits);
    const int expected = expected_sign(v);
    wrong += expected != sign_of(v);
    zero += expected == 0;
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(zero, 10u);
}

BOOST_AUTO_TEST_CASE(integers_of_64_bits_decide_in_space)
{
  check(20, [](const auto& v) {
    return internal::sign_of_product<std::int64_t>(
      internal::normal_of<std::int64_t>(v[0], v[1]), v[2]);
  });
}

BOOST_AUTO_TEST_CASE(integers_of_128_bits_decide_in_space)
{
  check(41, [](const auto& v) {
    return internal::sign_of_product<Int128>(internal::normal_of<Int128>(v[0], v[1]), v[2]);
  });
}

BOOST_AUTO_TEST_CASE(integers_of_192_bits_decide_in_space)
{
  for(const int bits : {3, 41, 60, 61})
    check(bits, [](const auto& v) {
      return internal::sign_of_long_product(internal::normal_of<Int128>(v[0], v[1]), v[2]);
    });
}

BOOST_AUTO_TEST_CASE(integers_decide_in_the_plane)
{
  Random random(1);
  std::size_t wrong = 0;
  for(int i = 0; i < 20000; ++i) {
    const std::array<Vector, 3> v = draw_vectors(random, i % 2 == 0 ? 30 : 61);
    const std::array<std::int64_t, 2> a = {v[0][0], v[0][1]}, b = {v[1][0], v[1][1]};
    const int expected = sign(minor(v[0], v[1], 0, 1));
    wrong += expected != internal::sign_of_determinant<Int128>(a, b);
    if(i % 2 == 0)
      wrong += expected != internal::sign_of_determinant<std::int64_t>(a, b);
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
}

BOOST_AUTO_TEST_CASE(halves_of_a_wide_integer_make_it)
{
  Random random(2);
  for(int i = 0; i < 1000; ++i) {
    const Int128 x = Int128(draw(random, 61)) * draw(random, 61) * 2;
    const internal::Split_integer split(x);
    BOOST_CHECK(Int128(split.high) * internal::Split_integer::unit + split.low == x);
    BOOST_CHECK(split.low >= 0 && split.low < internal::Split_integer::unit);
  }
}

BOOST_AUTO_TEST_SUITE_END()
