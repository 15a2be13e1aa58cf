// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_RECEIVES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_RECEIVES_H

// Which of two parts searches the pairs between them.

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether part a receives the points of part b that are near part a. Of two parts, exactly one
// receives. The parity shares the work: a part receives from about half of all others.
inline bool receives(int a, int b)
{
  return a != b && (a < b) == ((a + b) % 2 != 0);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_RECEIVES_H
