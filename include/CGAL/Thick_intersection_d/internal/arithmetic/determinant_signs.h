// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DETERMINANT_SIGNS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DETERMINANT_SIGNS_H

// The signs of determinants of two and of three vectors, of integers and of exact numbers.

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Number>
Sign sign_of_number(const Number& x)
{
  return x < Number(0) ? NEGATIVE : Number(0) < x ? POSITIVE : ZERO;
}

// Returns the sign of the determinant of two vectors. `Wide` has to hold both terms and their
// difference.
template <class Wide, class Number>
Sign sign_of_determinant(const std::array<Number, 2>& u, const std::array<Number, 2>& v)
{
  return sign_of_number(Wide(Wide(u[0]) * Wide(v[1]) - Wide(u[1]) * Wide(v[0])));
}

// Returns the cross product of two vectors. The determinant of three is its product with the third.
template <class Wide, class Number>
std::array<Wide, 3> normal_of(const std::array<Number, 3>& u, const std::array<Number, 3>& v)
{
  const auto minor = [&](std::size_t j, std::size_t k) {
    return Wide(Wide(u[j]) * Wide(v[k]) - Wide(u[k]) * Wide(v[j]));
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class Wide, class Number>
Sign sign_of_product(const std::array<Wide, 3>& normal, const std::array<Number, 3>& w)
{
  return sign_of_number(Wide(normal[0] * Wide(w[0]) + normal[1] * Wide(w[1])
                             + normal[2] * Wide(w[2])));
}

// The same in 192 bits, for vectors of numbers of up to 61 bits and a sign. The entries of the
// normal have up to 123 bits, and are split. So a product of a half with a number of 61 bits has at
// most 124 bits, and a sum of three of them has 126.
inline Sign sign_of_long_product(const std::array<Int128, 3>& normal,
                                 const std::array<std::int64_t, 3>& w)
{
  Int128 high = 0, low = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const Split_integer entry(normal[i]);
    high += Int128(entry.high) * w[i];
    low += Int128(entry.low) * w[i];
  }
  const Split_integer rest(low);
  high += rest.high;
  return high != 0 ? sign_of_number(high) : sign_of_number(rest.low);
}

// Returns the orientation of four points, whatever doubles they have. This is one function with a
// loop, because exact numbers make much code wherever they are inline.
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline Sign exact_orientation(const std::array<std::array<double, 3>, 4>& points)
{
  using Exact = Exact_number_t<double>;
  const auto difference = [&](std::size_t k, std::size_t axis) {
    return Exact(Exact(points[k][axis]) - Exact(points[0][axis]));
  };
  Exact determinant(0);
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Exact minor = Exact(difference(1, j) * difference(2, k))
                        - Exact(difference(1, k) * difference(2, j));
    determinant = Exact(determinant + minor * difference(3, i));
  }
  return CGAL::sign(determinant);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_DETERMINANT_SIGNS_H
