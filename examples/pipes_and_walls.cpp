// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which pipes touch or cross which walls: segments with a radius each, and triangles in space.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>
#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Pipe = std::pair<Kernel::Segment_3, Kernel::FT>;

int main()
{
  const std::vector<Pipe> pipes = {{{Point(1, -1, 1), Point(1, 1, 1)}, 0.25},
                                   {{Point(0, 2, 1), Point(8.5, 2, 1)}, 0.5},
                                   {{Point(8, 0.5, 1), Point(0, 0.5, 1)}, 0.5}};
  const std::vector<Kernel::Triangle_3> walls = {{Point(0, 0, 0), Point(4, 0, 0), Point(0, 0, 3)},
                                                 {Point(9, 0, 0), Point(9, 4, 0), Point(9, 0, 3)}};
  CGAL::thick_intersection_d(pipes, walls, [](std::size_t pipe, std::size_t wall) {
    std::cout << "pipe " << pipe << " touches or crosses wall " << wall << '\n';
  });
  CGAL::thick_self_intersection_d(pipes, [](std::size_t a, std::size_t b) {
    std::cout << "pipes " << a << " and " << b << " touch or cross\n";
  });
}
