// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of thick_self_intersection_d(), on triangles in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>

#include <cstddef>
#include <vector>

int main()
{
  using Point = CGAL::Epick::Point_3;
  const Point a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);
  const std::vector<CGAL::Epick::Triangle_3> triangles = {{a, b, c}, {a, b, d}};
  int count = 0;
  CGAL::thick_self_intersection_d(triangles, [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}
