// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLASSES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLASSES_H

// Boxes by the axes along which they are long.

#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Box>
class Box_classes
{
  static constexpr int axes = Box::axes;

public:
  static constexpr Place count = Place(1) << axes;

  Box_classes() = default;

  // Orders the boxes by their classes. A box is long along an axis if it is longer than `lengths`.
  Box_classes(const Span<Box>& boxes, const std::array<double, axes>& lengths)
  {
    const auto class_of = [&](const Box& box) {
      Place number = 0;
      for(int axis = 0; axis < axes; ++axis)
        number |= Place(box.high[axis] - box.low[axis] > lengths[axis]) << axis;
      return number;
    };
    Box* first = boxes.first;
    for(Place number = 0; number < count; ++number) {
      Box* const last = std::partition(
        first, boxes.last, [&](const Box& box) { return class_of(box) == number; });
      classes_[number] = {first, last};
      first = last;
    }
  }

  const Span<Box>& operator[](Place number) const { return classes_[number]; }

private:
  std::array<Span<Box>, count> classes_ = {};
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLASSES_H
