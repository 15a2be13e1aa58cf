// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of fixed_radius_neighbor_lists() in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <vector>

int main()
{
  const std::vector<CGAL::Epick::Point_3> points = {{0, 0, 0}, {0, 0.05, 0}};
  const auto lists = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(0.1));
  return lists[0].size() == 1 ? 0 : 1;
}
