// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which atoms touch which triangles of a surface. An atom is a ball: a center and a radius.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>
#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

int main()
{
  const std::vector<std::pair<Point, double>> atoms = {{Point(1, 1, 1.7), 1.7},
                                                       {Point(5, 1, 1.7), 1.2}};
  const std::vector<Kernel::Triangle_3> surface
    = {{Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)},
       {Point(4, 0, 0), Point(8, 0, 0), Point(4, 4, 0)}};
  CGAL::thick_intersection_d(atoms, surface, [](std::size_t atom, std::size_t triangle) {
    std::cout << "atom " << atom << " touches triangle " << triangle << '\n';
  });
}
