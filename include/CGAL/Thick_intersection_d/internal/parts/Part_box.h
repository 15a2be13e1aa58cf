// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_BOX_H

// The closed box of the points of a part, and the points that are near it.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Holds the doubles that enclose the coordinates of the points themselves. Where space was cut does
// not matter, so the points of a part may be any points.
class Part_box
{
public:
  explicit Part_box(int dimension) : intervals_(static_cast<std::size_t>(dimension)) {}
  explicit Part_box(std::vector<Interval> intervals) : intervals_(std::move(intervals)) {}

  const std::vector<Interval>& intervals() const { return intervals_; }
  bool is_empty() const { return intervals_.empty() || intervals_[0].low > intervals_[0].high; }

  std::pair<double, double> bounds_along(int axis) const
  {
    const Interval& interval = intervals_[static_cast<std::size_t>(axis)];
    return {interval.low, interval.high};
  }

  // Extends the box until it holds a point or another box. `bounds_along(axis)` of an object
  // encloses its coordinate.
  template <class Object>
  void add(const Object& object)
  {
    for(std::size_t axis = 0; axis < intervals_.size(); ++axis) {
      const std::pair<double, double> x = object.bounds_along(static_cast<int>(axis));
      intervals_[axis].add(Interval{x.first, x.second});
    }
  }

  // Returns false only if each point of the part is farther than `reach` from this object along an
  // axis. If a point y of the part is within reach along an axis, then low - sup x <= y - x, which
  // is at most the reach in real numbers, so the rounded difference is as well (Lemma M,
  // doc/proofs.md). The other side is its mirror image. Sums of squares would be rounded more than
  // once, and lose ties.
  template <class Object>
  bool is_near(const Object& object, double reach) const
  {
    if(is_empty())
      return false;
    for(std::size_t axis = 0; axis < intervals_.size(); ++axis) {
      const std::pair<double, double> x = object.bounds_along(static_cast<int>(axis));
      const bool is_near_low = intervals_[axis].low - x.second <= reach;
      const bool is_near_high = x.first - intervals_[axis].high <= reach;
      if(!is_near_low || !is_near_high)
        return false;
    }
    return true;
  }

private:
  std::vector<Interval> intervals_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_BOX_H
