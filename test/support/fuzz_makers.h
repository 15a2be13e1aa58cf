// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Random scenes in the numbers and points of a kernel: a maker per kind of kernel.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_FUZZ_MAKERS_H
#define THICK_INTERSECTION_TEST_SUPPORT_FUZZ_MAKERS_H

#include "fuzz_scenes.h"
#include "kernel_types.h"

#include <CGAL/Exact_rational.h>

namespace test_support {

inline CGAL::Exact_rational exact_rational(const Wide_integer& x)
{
  constexpr int digits = 32;
  const Wide_integer low = x & ((Wide_integer(1) << digits) - 1);
  const CGAL::Exact_rational number(static_cast<double>(low));
  return x == low ? number
                  : CGAL::Exact_rational(exact_rational(Wide_integer(x >> digits))
                                           * CGAL::Exact_rational(std::ldexp(1., digits))
                                         + number);
}

// Cartesian coordinates. The unit is a third of the power of two if numbers are exact, so that no
// double holds a coordinate.
template <class K, int Dimension, bool is_exact_>
struct Fuzz_coordinates
{
  using Kernel = K;
  using FT = typename Kernel::FT;
  static constexpr int dimension = Dimension;
  static constexpr bool is_exact = is_exact_;
  static constexpr Number_range range = std::is_same_v<FT, float> ? range_of_floats
                                        : std::is_integral_v<FT>  ? range_of_integers
                                                                  : range_of_doubles;

  static FT number(std::int64_t place, int exponent)
  {
    const FT number(std::ldexp(static_cast<double>(place), exponent));
    if constexpr(is_exact)
      return FT(number / FT(3));
    else
      return number;
  }
};

// Points of a kernel for the plane and for space.
template <class K, int Dimension, bool is_exact>
struct Fuzz_cartesian : Fuzz_coordinates<K, Dimension, is_exact>
{
  using Fuzz_coordinates<K, Dimension, is_exact>::number;
  using Types = Kernel_types<K, Dimension>;
  using Point = typename Types::Point;

  static Point point(const Lattice_place& p, int exponent)
  {
    return Types::point([&](std::size_t axis) { return number(p[axis], exponent); });
  }
};

// Exact numbers that no double is between, so that all boxes of doubles meet.
template <class K, int Dimension>
struct Fuzz_close : Fuzz_cartesian<K, Dimension, true>
{
  using FT = typename K::FT;

  static auto point(const Lattice_place& p, int)
  {
    return Kernel_types<K, Dimension>::point([&](std::size_t axis) {
      return FT(FT(1) + FT(std::ldexp(static_cast<double>(p[axis]), -120)));
    });
  }
};

// Points of a kernel for any dimension.
template <class K, int Dimension, bool is_exact>
struct Fuzz_points_d : Fuzz_coordinates<K, Dimension, is_exact>
{
  using Point = typename K::Point_d;

  static Point point(const Lattice_place& p, int exponent)
  {
    std::vector<typename K::FT> coordinates;
    for(int axis = 0; axis < Dimension; ++axis)
      coordinates.push_back(Fuzz_points_d::number(p[axis], exponent));
    return Point(coordinates.begin(), coordinates.end());
  }
};

// Homogeneous points over the integers, with 3 or 3 times a power of two as the last coordinate.
template <class K, int Dimension>
struct Fuzz_homogeneous
{
  using Kernel = K;
  using RT = typename Kernel::RT;
  using FT = typename Kernel::FT;
  using Types = Kernel_types<Kernel, Dimension>;
  using Point = typename Types::Point;
  static constexpr int dimension = Dimension;
  static constexpr bool is_exact = true;
  static constexpr Number_range range = range_of_doubles;

  static RT power(int exponent)
  {
    RT power(1);
    for(; exponent > 0; --exponent)
      power *= RT(2);
    return power;
  }

  static RT numerator(std::int64_t place, int exponent)
  {
    return RT(RT(static_cast<double>(place)) * power(exponent));
  }

  static FT number(std::int64_t place, int exponent)
  {
    return FT(numerator(place, exponent), RT(RT(3) * power(-exponent)));
  }

  static Point point(const Lattice_place& p, int exponent)
  {
    const RT w(RT(3) * power(-exponent));
    return Types::point([&](std::size_t axis) { return numerator(p[axis], exponent); }, w);
  }
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_FUZZ_MAKERS_H
