// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Takes the place of a header of the library: the lanes that every processor has, which are the
// last ones in the lists.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PLAIN_LANES_FIRST_SUPPORTED_H
#define THICK_INTERSECTION_TEST_SUPPORT_PLAIN_LANES_FIRST_SUPPORTED_H

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class First, class... Others>
struct First_supported : First_supported<Others...> {};
template <class Last>
struct First_supported<Last> : Last {};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // THICK_INTERSECTION_TEST_SUPPORT_PLAIN_LANES_FIRST_SUPPORTED_H
