// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_DIVIDE_INTO_CLASSES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_DIVIDE_INTO_CLASSES_H

// Boxes by the axes along which they are long.

#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Puts the boxes of each class next to each other. Returns the classes that have any boxes. A box
// is long along an axis if it is longer than `lengths`.
template <class Box>
std::vector<Span<Box>> divide_into_classes(const Span<Box>& boxes,
                                           const std::array<double, Box::axes>& lengths)
{
  std::vector<Span<Box>> classes(1, boxes);
  for(int axis = 0; axis < Box::axes; ++axis) {
    std::vector<Span<Box>> parts;
    for(const Span<Box>& span : classes) {
      Box* const first_long = std::partition(span.first, span.last, [&](const Box& box) {
        return !(box.high[axis] - box.low[axis] > lengths[axis]);
      });
      for(const Span<Box>& part : {Span<Box>{span.first, first_long}, {first_long, span.last}})
        if(part.size() != 0)
          parts.push_back(part);
    }
    classes.swap(parts);
  }
  return classes;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_DIVIDE_INTO_CLASSES_H
