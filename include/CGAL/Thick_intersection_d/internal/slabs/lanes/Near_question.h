// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_QUESTION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_QUESTION_H

// The question that lanes ask about two points.

#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Near_question
{
  double reach;           // along axis 0
  Distance_filter filter; // of the squared distance
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_QUESTION_H
