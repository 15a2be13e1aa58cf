// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_VECTORS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_VECTORS_H

// Vectors of doubles, with rounding, of integers, and of exact numbers, whose sums and products may
// be expressions of another type.

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Number, std::size_t N>
Number dot_product(const std::array<Number, N>& u, const std::array<Number, N>& v)
{
  Number sum(u[0] * v[0]);
  for(std::size_t i = 1; i < N; ++i)
    sum = Number(sum + u[i] * v[i]);
  return sum;
}

template <class Number, std::size_t N>
std::array<Number, N> vector_difference(const std::array<Number, N>& u,
                                        const std::array<Number, N>& v)
{
  std::array<Number, N> w;
  for(std::size_t i = 0; i < N; ++i)
    w[i] = Number(u[i] - v[i]);
  return w;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_VECTORS_H
