// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that slabs can be made of and swept, with every pair in reach left undecided and counted.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_UNDECIDED_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_UNDECIDED_POINTS_H

#include "point_source.h"

#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>

#include <cstddef>

namespace test_support {

template <int Dimension>
struct Undecided_points : Point_source<Dimension>
{
  using Point_source<Dimension>::Point_source;

  bool is_pair(std::size_t, std::size_t, internal::Decision_counts&) const override
  {
    ++count;
    return false;
  }

  mutable std::size_t count = 0;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_UNDECIDED_POINTS_H
