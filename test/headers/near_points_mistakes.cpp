// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls that do not compile with the header of points alone. Otherwise as mistakes.cpp.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/fixed_radius_near_points.h>

#include <cstddef>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

const std::vector<Kernel::Segment_2> segments;
const std::vector<Kernel::Point_2> points;
const auto bound = CGAL::within_distance(1);
const auto report = [](std::size_t, std::size_t) {};

void make_mistakes()
{
  // error: For objects that are no points, and for traits of one's own, include
  // <CGAL/fixed_radius_near_neighbors.h>.
  CGAL::fixed_radius_near_neighbors(segments, bound, report);

  // error: For objects that are no points, and for traits of one's own, include
  // <CGAL/fixed_radius_near_neighbors.h>.
  CGAL::fixed_radius_near_neighbors(points, segments, bound, report);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::fixed_radius_near_neighbors(points, 1.0, report);
}
