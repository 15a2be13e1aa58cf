// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of closest_pair() in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/closest_pair.h>

#include <vector>

int main()
{
  const std::vector<CGAL::Epick::Point_3> points = {{0, 0, 0}, {0, 1, 0}, {3, 0, 0}};
  return CGAL::closest_pair(points).second == 1 ? 0 : 1;
}
