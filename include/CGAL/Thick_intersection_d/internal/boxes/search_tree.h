// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_SEARCH_TREE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_SEARCH_TREE_H

// Searches the boxes of a piece by a tree, and asks about those that meet.

#include <CGAL/Thick_intersection_d/internal/boxes/Box_tree.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/has_groups.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Reports two boxes that meet if their objects intersect.
template <class Test, class Report>
struct Tested_report
{
  using Box = typename Test::Box;
  static constexpr bool has_groups = has_groups_v<Test>;

  const Test& test;
  Report& report;

  std::size_t group_of(const Box& box) const { return test.group_of(box.position); }

  bool is_wanted(const Box& a, const Box& b) const
  {
    return test.is_wanted(a.position, b.position);
  }

  bool operator()(const Box& a, const Box& b)
  {
    if(!is_wanted(a, b) || !test.do_intersect(a.position, b.position))
      return !report.is_stopped();
    return a.position < b.position ? report(a.position, b.position)
                                   : report(b.position, a.position);
  }
};

// Boxes that are copies along a common axis are not searched for pairs, so no pair is found in two
// pieces.
template <class Box, class Test, class Report>
void search_tree(const Piece<Box>& piece, const Test& test, Report& report)
{
  Tested_report<Test, Report> tested_report = {test, report};
  Box_tree<Box, Tested_report<Test, Report>> tree(tested_report);
  using Boxes_by_sides = std::array<std::vector<const Box*>, std::size_t(1) << Box::axes>;
  std::array<Boxes_by_sides, 2> boxes;
  for(std::size_t set = 0; set < 2; ++set)
    for(const Box* box = piece[set].first; box != piece[set].last; ++box)
      boxes[set][box->sides].push_back(box);
  const bool is_one_set = piece.set_count() == 1;
  const Boxes_by_sides& others = boxes[is_one_set ? 0 : 1];
  bool goes_on = true;
  for(std::size_t a = 0; a < boxes[0].size(); ++a)
    for(std::size_t b = is_one_set ? a : 0; b < others.size(); ++b)
      if((a & b) == 0 && goes_on)
        goes_on = is_one_set && a == b ? tree.within(boxes[0][a])
                                       : tree.between(boxes[0][a], others[b]);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_SEARCH_TREE_H
