// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H

// The last step of a tree, as Box_scan, for boxes that have groups: of the boxes of a group that is
// not wanted, only the first one is looked at.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxes_by_group.h>
#include <CGAL/Thick_intersection_d/internal/boxes/begins_before.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A box, and the number of its group among those of the boxes of a tree.
template <class Box>
struct Box_of_group : Box
{
  explicit Box_of_group(const Box& box) : Box(box) {}

  Place group = 0;
};

// `Report` is as for Box_tree, and has groups (has_groups.h), of boxes.
template <class Box, class Report>
class Group_scan
{
public:
  using Copy = Box_of_group<Box>;
  using Boxes = std::vector<const Copy*>;

  explicit Group_scan(Report& report) : report_(report) {}

  // Numbers the groups of the boxes, which may be the same ones twice.
  void set_boxes(std::vector<Copy>& a, std::vector<Copy>& b)
  {
    std::vector<std::size_t> groups;
    for(const std::vector<Copy>* boxes : {&a, &b})
      for(const Copy& box : *boxes)
        groups.push_back(report_.group_of(box));
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for(std::vector<Copy>* boxes : {&a, &b})
      for(Copy& box : *boxes)
        box.group = static_cast<Place>(
          std::lower_bound(groups.begin(), groups.end(), report_.group_of(box)) - groups.begin());
    by_group_.set_group_count(static_cast<Place>(groups.size()));
  }

  // Takes one step for each box, for each group of which a box holds a lower end, and for each
  // wanted pair.
  bool search(const Boxes& holding, const Boxes& starting)
  {
    std::size_t first = starting.size();
    by_group_.restart(static_cast<Place>(first));
    // Invariant: by_group_ has the boxes from `first` on, which begin behind the last box taken.
    for(auto a = holding.rbegin(); a != holding.rend(); ++a) {
      while(first != 0 && begins_before(*a, starting[first - 1], 0)) {
        --first;
        by_group_.push_front(static_cast<Place>(first), starting[first]->group);
      }
      for(Place group = by_group_.first(); is_held(starting, group, **a);
          group = by_group_.next_group(group))
        if(!report_wanted(**a, starting, group))
          return false;
    }
    return true;
  }

private:
  // Whether there is a box at a place, and it begins before `a` ends.
  static bool is_held(const Boxes& starting, Place place, const Copy& a)
  {
    return place != Boxes_by_group::none && starting[place]->low[0] <= a.high[0];
  }

  // Reports the pairs of `a` and the boxes of a group, from its first one on, as long as they are
  // wanted.
  bool report_wanted(const Copy& a, const Boxes& starting, Place first)
  {
    for(Place b = first; is_held(starting, b, a) && report_.is_wanted(a, *starting[b]);
        b = by_group_.next_in_group(b))
      if(!report_(a, *starting[b]))
        return false;
    return true;
  }

  Report& report_;
  Boxes_by_group by_group_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H
