// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_NEAR_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_NEAR_BOXES_H

// Which parts receive a point, by the boxes of all parts.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

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

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_NEAR_BOXES_H
