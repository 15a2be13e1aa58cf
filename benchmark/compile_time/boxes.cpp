// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of thick_box_self_intersection_d(), on boxes of CGAL in space.

#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_box_intersection_d.h>

#include <vector>

int main()
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  const std::vector<Box> boxes = {CGAL::Bbox_3(0, 0, 0, 1, 1, 1), CGAL::Bbox_3(0, 1, 0, 1, 2, 1)};
  int count = 0;
  CGAL::thick_box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [&](const Box&, const Box&) { ++count; });
  return count == 1 ? 0 : 1;
}
