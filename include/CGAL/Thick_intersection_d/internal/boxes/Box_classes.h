// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLASSES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLASSES_H

// Boxes by the axes along which they are long.

#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Box>
class Box_classes
{
  static constexpr int axes = Box::axes;

public:
  Box_classes() = default;

  // Orders the boxes by their classes. A box is long along an axis if it is longer than `lengths`.
  Box_classes(const Span<Box>& boxes, const std::array<double, axes>& lengths)
  {
    divide(boxes, lengths, 0);
  }

  // The boxes of each class that has any.
  const std::vector<Span<Box>>& spans() const { return spans_; }

private:
  // Divides boxes that are in the same class as far as the axes before `axis` tell.
  void divide(const Span<Box>& boxes, const std::array<double, axes>& lengths, int axis)
  {
    if(boxes.size() == 0)
      return;
    if(axis == axes) {
      spans_.push_back(boxes);
      return;
    }
    Box* const first_long = std::partition(boxes.first, boxes.last, [&](const Box& box) {
      return !(box.high[axis] - box.low[axis] > lengths[axis]);
    });
    divide({boxes.first, first_long}, lengths, axis + 1);
    divide({first_long, boxes.last}, lengths, axis + 1);
  }

  std::vector<Span<Box>> spans_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_CLASSES_H
