// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which buildings are within 5 m of which road. A building is a rectangle or a triangle.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/fixed_radius_near_neighbors.h>
#include <iostream>
#include <variant>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Building = std::variant<Kernel::Iso_rectangle_2, Kernel::Triangle_2>;

int main()
{
  const std::vector<Building> buildings
    = {Kernel::Iso_rectangle_2(Point(0, 0), Point(10, 8)),
       Kernel::Triangle_2(Point(20, 6), Point(30, 0), Point(30, 12))};
  const std::vector<Kernel::Segment_2> roads = {{Point(-50, 13), Point(50, 13)}};
  const auto print = [](std::size_t building, std::size_t road) {
    std::cout << "building " << building << " is near road " << road << '\n';
  };
  CGAL::fixed_radius_near_neighbors(buildings, roads, CGAL::within_distance(5), print);
}
