// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which pipes cross which walls: segments and triangles in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

int main()
{
  const std::vector<Kernel::Segment_3> pipes = {{Point(1, -1, 1), Point(1, 1, 1)},
                                                {Point(0, 2, 1), Point(9, 2, 1)}};
  const std::vector<Kernel::Triangle_3> walls = {{Point(0, 0, 0), Point(4, 0, 0), Point(0, 0, 3)},
                                                 {Point(9, 0, 0), Point(9, 4, 0), Point(9, 0, 3)}};
  CGAL::thick_intersection_d(pipes, walls, [](std::size_t pipe, std::size_t wall) {
    std::cout << "pipe " << pipe << " crosses wall " << wall << '\n';
  });
}
