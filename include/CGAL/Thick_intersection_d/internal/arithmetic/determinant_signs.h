// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DETERMINANT_SIGNS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DETERMINANT_SIGNS_H

// The signs of determinants of integers and of exact numbers, in rows of two or three.

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Number, std::size_t N>
using Square_matrix = std::array<std::array<Number, N>, N>;

template <class Number>
Sign sign_of_number(const Number& x)
{
  return x < Number(0) ? NEGATIVE : Number(0) < x ? POSITIVE : ZERO;
}

// Computes in the type `Wide`, which has to hold all products and their sum.
template <class Wide, class Number>
Sign sign_of_determinant(const Square_matrix<Number, 2>& m)
{
  return sign_of_number(Wide(Wide(m[0][0]) * Wide(m[1][1]) - Wide(m[0][1]) * Wide(m[1][0])));
}

// The minor of the rows 1 and 2 without column i, of the columns that follow i in cyclic order.
template <class Wide, class Number>
Wide minor_without_column(const Square_matrix<Number, 3>& m, std::size_t i)
{
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return Wide(m[1][j]) * Wide(m[2][k]) - Wide(m[1][k]) * Wide(m[2][j]);
}

template <class Wide, class Number>
Sign sign_of_determinant(const Square_matrix<Number, 3>& m)
{
  Wide sum(0);
  for(std::size_t i = 0; i < 3; ++i)
    sum = sum + minor_without_column<Wide>(m, i) * Wide(m[0][i]);
  return sign_of_number(sum);
}

// The same in 192 bits, for numbers of up to 61 bits and a sign. A minor has up to 123 bits, and is
// split into high 2^60 + low, with |low| < 2^60. So each product with a number of 61 bits, and each
// sum of three of them, has at most 126 bits.
inline Sign sign_of_long_determinant(const Square_matrix<std::int64_t, 3>& m)
{
  const Int128 unit = Int128(1) << 60;
  Int128 high = 0, low = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const Int128 minor = minor_without_column<Int128>(m, i);
    high += minor / unit * m[0][i];
    low += minor % unit * m[0][i];
  }
  high += low / unit;
  low %= unit; // so the sign is that of `high`, unless that is zero
  return high != 0 ? sign_of_number(high) : sign_of_number(low);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DETERMINANT_SIGNS_H
