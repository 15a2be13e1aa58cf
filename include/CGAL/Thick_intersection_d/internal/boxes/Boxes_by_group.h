// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXES_BY_GROUP_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXES_BY_GROUP_H

// The boxes of a list from some place on, by their groups. Who looks for the boxes of some groups
// takes one step for each other group, and none for each of its boxes.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Each group is a list of its boxes in ascending order. The groups are in a list themselves, which
// goes through the first boxes of groups, in ascending order as well.
class Boxes_by_group
{
public:
  static constexpr Place none = max_place;

  // Groups have the numbers from 0 to `count` - 1.
  void set_group_count(Place count) { first_of_group_.assign(count, none); }

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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOXES_BY_GROUP_H
