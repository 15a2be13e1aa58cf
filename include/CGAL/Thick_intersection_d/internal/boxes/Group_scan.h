// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H

// The last step of a tree of boxes that have groups: of the boxes of a group that is not wanted,
// only the first one is looked at.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Boxes_by_group.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Box>
class Group_scan
{
public:
  using Boxes = std::vector<const Box*>;
  using Client = Box_client<Box::axes>;

  explicit Group_scan(Client& client) : client_(client) {}

  // Numbers the groups of the boxes, which may be the same ones twice. The number of a group takes
  // the place of the sides of a box, which nobody asks for in a tree.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  void set_boxes(std::vector<Box>& a, std::vector<Box>& b)
  {
    std::vector<std::size_t> groups;
    for(const std::vector<Box>* boxes : {&a, &b})
      for(const Box& box : *boxes)
        groups.push_back(client_.group_of(box.position));
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for(std::vector<Box>* boxes : {&a, &b})
      for(Box& box : *boxes) {
        const std::size_t group = client_.group_of(box.position);
        box.sides = static_cast<Place>(
          std::lower_bound(groups.begin(), groups.end(), group) - groups.begin());
      }
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
        by_group_.push_front(static_cast<Place>(first), starting[first]->sides);
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
  static bool is_held(const Boxes& starting, Place place, const Box& a)
  {
    return place != Boxes_by_group::none && starting[place]->low[0] <= a.high[0];
  }

  // Reports the pairs of `a` and the boxes of a group, from its first one on, as long as they are
  // wanted.
  bool report_wanted(const Box& a, const Boxes& starting, Place first)
  {
    for(Place b = first;
        is_held(starting, b, a) && client_.is_wanted(a.position, starting[b]->position);
        b = by_group_.next_in_group(b))
      if(!client_.take_pair(a.position, starting[b]->position))
        return false;
    return true;
  }

  Client& client_;
  Boxes_by_group by_group_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H
