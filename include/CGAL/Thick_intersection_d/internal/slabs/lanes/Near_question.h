// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_QUESTION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_QUESTION_H

// The question that lanes ask about two points.

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// What sums of squares of differences are computed in.
template <class Number>
using Real_of = std::conditional_t<std::is_same_v<Number, double>, double, float>;

template <class Number>
struct Near_question
{
  Number reach;            // along axis 0
  Real_of<Number> inside;  // a computed squared distance up to it is certainly within the bound
  Real_of<Number> outside; // and one above it is certainly beyond
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LANES_NEAR_QUESTION_H
