// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// One call of thick_self_intersection_d().

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>

#include <cstddef>
#include <vector>

int main()
{
  const std::vector<CGAL::Epick::Segment_2> segments = {{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}};
  int count = 0;
  CGAL::thick_self_intersection_d(segments, [&](std::size_t, std::size_t) { ++count; });
  return count == 1 ? 0 : 1;
}
