// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BEGINS_BEFORE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BEGINS_BEFORE_H

// The order of the lower ends of boxes.

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The lower ends of boxes are ordered by coordinate and position, so no two of them are equal. Two
// boxes meet along an axis iff one of them holds the lower end of the other one: it begins before
// the other one begins, and does not end before.
template <class Box>
bool begins_before(const Box* a, const Box* b, int axis)
{
  const double x = a->low[axis];
  const double y = b->low[axis];
  return x < y || (x == y && a->position < b->position);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BEGINS_BEFORE_H
