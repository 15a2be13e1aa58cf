// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_WIDE_INTEGERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_WIDE_INTEGERS_H

// Integers of 128 bits, and their halves.

#include <cstdint>

#ifndef __SIZEOF_INT128__
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 Uint128;
__extension__ typedef __int128 Int128;
#else
using Uint128 = boost::multiprecision::uint128_t;
using Int128 = boost::multiprecision::int128_t;
#endif

// x = high 2^60 + low, with 0 <= low < 2^60, for |x| < 2^123.
struct Split_integer
{
  explicit Split_integer(Int128 x)
  {
#ifdef __SIZEOF_INT128__
    high = static_cast<std::int64_t>(x >> 60);
    low = static_cast<std::int64_t>(x) & (unit - 1);
#else
    high = static_cast<std::int64_t>(x / unit);
    low = static_cast<std::int64_t>(x % unit);
    high -= low < 0;
    low += low < 0 ? unit : 0;
#endif
  }

  static constexpr std::int64_t unit = std::int64_t(1) << 60;
  std::int64_t high;
  std::int64_t low;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_WIDE_INTEGERS_H
