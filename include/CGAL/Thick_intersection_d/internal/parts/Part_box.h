// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_BOX_H

// The closed box of the points of a part, the points that are near it, and which parts receive a
// point.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>

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

// Whether part a receives the points of part b that are near part a. Of two parts, exactly one
// receives. The parity shares the work: a part receives from about half of all others.
inline bool receives(int a, int b)
{
  return a != b && (a < b) == ((a + b) % 2 != 0);
}

// Finds the parts that receive a point of one part: it is near one of their boxes.
class Near_boxes
{
public:
  // The boxes of all parts are `intervals`, box by box; `parts`, in order, tells whose they are.
  // `mine` are those of `part`.
  Near_boxes(const std::vector<Part_box>& mine, int part, const std::vector<int>& parts,
             const std::vector<Interval>& intervals, double reach)
    : reach_(reach), near_(mine.size())
  {
    for(std::size_t i = 0; i < parts.size(); ++i) {
      if(!receives(parts[i], part))
        continue;
      const std::size_t dimension = intervals.size() / parts.size();
      const Interval* const first = intervals.data() + i * dimension;
      const Part_box box({first, first + dimension});
      for(std::size_t m = 0; m < mine.size(); ++m)
        if(!mine[m].is_empty() && box.is_near(mine[m], reach))
          near_[m].push_back({parts[i], box});
    }
  }

  // Calls visit(part) for each part that receives a point. The point is in box `m` of its own part.
  template <class Point, class Visit>
  void for_receivers(std::size_t m, const Point& point, const Visit& visit) const
  {
    int last = -1; // the last part that receives the point
    for(const Other_box& other : near_[m])
      if(other.part != last && other.box.is_near(point, reach_))
        visit(last = other.part);
  }

private:
  struct Other_box
  {
    int part;
    Part_box box;
  };

  double reach_;
  std::vector<std::vector<Other_box>> near_; // of each box, in the order of parts
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_PART_BOX_H
