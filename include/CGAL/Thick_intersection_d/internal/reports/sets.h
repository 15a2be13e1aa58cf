// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_SETS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_SETS_H

// Which pairs a search reports: those of one set, or those between two. It is a type, so that only
// one of the two searches is compiled for a call.

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// All elements.
struct One_set
{
  static constexpr bool are_two = false;
};

// The first `first_size` elements, and the others.
struct Two_sets
{
  static constexpr bool are_two = true;
  std::size_t first_size;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_SETS_H
