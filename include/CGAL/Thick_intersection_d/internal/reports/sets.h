// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_SETS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_SETS_H

// Whether a search reports the pairs in one set, or the pairs between two sets. This is a type, so
// a call compiles only one of the two searches.

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// All elements.
struct One_set
{
  static constexpr bool are_two = false;
};

// The first `first_size` elements, and all other elements.
struct Two_sets
{
  static constexpr bool are_two = true;
  std::size_t first_size;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_SETS_H
