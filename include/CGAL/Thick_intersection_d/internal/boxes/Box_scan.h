// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SCAN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SCAN_H

// The last step of a tree: the pairs of boxes that meet along axis 0, if all meet along the others.

#include <CGAL/Thick_intersection_d/internal/boxes/begins_before.h>

#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Report` is as for Box_tree.
template <class Box, class Report>
class Box_scan
{
public:
  using Copy = Box; // of which the tree has lists
  using Boxes = std::vector<const Copy*>;

  explicit Box_scan(Report& report) : report_(report) {}

  // The boxes of the lists that follow are among these.
  void set_boxes(std::vector<Copy>&, std::vector<Copy>&) {}

  // Reports the pairs of a box that holds the lower end, along axis 0, of one of `starting`. The
  // lists are sorted along this axis.
  bool search(const Boxes& holding, const Boxes& starting)
  {
    auto first = starting.begin();
    for(const Copy* a : holding) {
      while(first != starting.end() && !begins_before(a, *first, 0))
        ++first;
      for(auto b = first; b != starting.end() && (*b)->low[0] <= a->high[0]; ++b)
        if(!report_(*a, **b))
          return false;
    }
    return true;
  }

private:
  Report& report_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_SCAN_H
