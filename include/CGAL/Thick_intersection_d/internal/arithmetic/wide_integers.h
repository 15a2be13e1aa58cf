// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_WIDE_INTEGERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_WIDE_INTEGERS_H

// Integers of 128 bits.

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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_ARITHMETIC_WIDE_INTEGERS_H
