// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of fixed_radius_near_neighbors(), on segments in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <cstddef>
#include <vector>

int main()
{
  using Point = CGAL::Epick::Point_3;
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 2);
  const std::vector<CGAL::Epick::Segment_3> segments = {{a, b}, {c, d}};
  int count = 0;
  CGAL::fixed_radius_near_neighbors(segments, CGAL::within_distance(1),
                                    [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}
