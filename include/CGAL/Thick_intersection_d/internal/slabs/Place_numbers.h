// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_PLACE_NUMBERS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_PLACE_NUMBERS_H

// Numbers for the points of slabs that become ready. Searches of pairs need none, and do not
// compile what gives them.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Place_numbers
{
public:
  // Returns the first of `size` consecutive numbers for a slab behind those in the window. Sets
  // `positions` to where to write the positions of its points, by their numbers from there on.
  virtual Place add(Place size, Place*& positions) = 0;

protected:
  ~Place_numbers() = default;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_PLACE_NUMBERS_H
