// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_GROUP_SCAN_H

// The last step of a tree of boxes that have groups: of the boxes of a group that is not wanted,
// only the first one is looked at.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Box_client.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The boxes of a list from some place on, by their groups. Who looks for the boxes of some groups
// takes one step for each other group, and none for each of its boxes.
//
// Each group is a list of its boxes in ascending order. The groups are in a list themselves, which
// goes through the first boxes of groups, in ascending order as well.
class Boxes_by_group
{
public:
  static constexpr Place none = max_place;

  // Groups have the numbers from 0 to `count` - 1. No box is here.
  void set_group_count(Place count)
  {
    first_of_group_.assign(count, none);
    first_ = none;
  }

  // Begins a list of `size` boxes, none of which is here yet.
  void restart(Place size)
  {
    for(Place box = first_; box != none; box = links_[box].next_group)
      first_of_group_[links_[box].group] = none;
    first_ = none;
    links_.resize(size);
  }

  // Adds a box that is before all others. It becomes the first of its group, and its group the
  // first one.
  void push_front(Place box, Place group)
  {
    const Place next = first_of_group_[group];
    if(next != none)
      take_out(next);
    links_[box] = {group, next, first_, none};
    if(first_ != none)
      links_[first_].previous_group = box;
    first_ = box;
    first_of_group_[group] = box;
  }

  // The first box of the first group, or `none`.
  Place first() const { return first_; }

  // The first box of the group that follows that of another first box, or `none`.
  Place next_group(Place box) const { return links_[box].next_group; }

  // The next box of the same group, or `none`.
  Place next_in_group(Place box) const { return links_[box].next_in_group; }

private:
  struct Links
  {
    Place group;
    Place next_in_group;
    Place next_group; // of the first box of a group, as is the next one
    Place previous_group;
  };

  // Takes the first box of a group out of the list of groups.
  void take_out(Place box)
  {
    const Links& links = links_[box];
    (links.previous_group == none ? first_ : links_[links.previous_group].next_group)
      = links.next_group;
    if(links.next_group != none)
      links_[links.next_group].previous_group = links.previous_group;
  }

  std::vector<Links> links_;          // of each box
  std::vector<Place> first_of_group_; // or `none`
  Place first_ = none;
};

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
