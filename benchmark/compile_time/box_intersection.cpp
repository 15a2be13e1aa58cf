// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of CGAL::box_self_intersection_d(), for comparison.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <vector>

int main()
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 2>;
  std::vector<Box> boxes = {Box(CGAL::Bbox_2(0, 0, 1, 1)), Box(CGAL::Bbox_2(0, 1, 1, 2))};
  int count = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box&, const Box&) { ++count; });
  return count == 1 ? 0 : 1;
}
