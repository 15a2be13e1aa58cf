// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Houses that are within 5 m of a road, and what is inside of a park: polylines and polygons.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/thick_feature_intersection_d.h>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

int main()
{
  const std::vector<std::vector<Kernel::Point_2>> roads
    = {{{0, 0}, {40, 0}, {80, 30}}, {{10, 60}, {20, 70}}};
  const auto house = [](double x, double y) {
    const Kernel::Point_2 corners[] = {{x, y}, {x + 8, y}, {x + 8, y + 6}, {x, y + 6}};
    return Polygon(corners, corners + 4);
  };
  const std::vector<Polygon> houses = {house(0, 5), house(20, 5.1), house(30, 4), house(70, 40)};
  CGAL::fixed_radius_near_features(roads, houses, CGAL::within_distance(5),
                                   [](std::size_t road, std::size_t i)
                                   { std::cout << "house " << i << ": road " << road << '\n'; });
  const Kernel::Point_2 corners[] = {{0, 50}, {90, 30}, {90, 90}, {0, 90}};
  const std::vector<Polygon> parks = {Polygon(corners, corners + 4)};
  CGAL::thick_feature_intersection_d(parks, roads, [](std::size_t, std::size_t road)
                                     { std::cout << "road " << road << " meets the park\n"; });
}
