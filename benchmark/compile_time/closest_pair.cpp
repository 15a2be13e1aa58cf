// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of closest_pair().

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/closest_pair.h>

#include <vector>

int main()
{
  const std::vector<CGAL::Epick::Point_2> points = {{0, 0}, {0, 1}, {3, 0}};
  return CGAL::closest_pair(points).second == 1 ? 0 : 1;
}
