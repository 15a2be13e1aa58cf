// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points of a Point_set_3 that have few neighbors, as noise in a scan has. The elements of a point
// set are indices, and lists of neighbors go by the position in the range.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h> // under the GPL, unlike the package
#include <CGAL/fixed_radius_near_neighbors.h>

#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

// Removes the points with fewer neighbors than `least`.
void remove_outliers(Point_set& points, double distance, std::size_t least)
{
  const auto neighbors
    = CGAL::fixed_radius_neighbor_lists(points, CGAL::within_distance(distance));
  std::vector<Point_set::Index> outliers;
  std::size_t position = 0;
  for(const Point_set::Index& index : points)
    if(neighbors[position++].size() < least)
      outliers.push_back(index);
  for(const Point_set::Index& index : outliers)
    points.remove(index);
}

// Points of two surfaces, and a few points that are on neither.
Point_set make_points()
{
  Point_set points;
  for(int x = 0; x < 50; ++x)
    for(int y = 0; y < 50; ++y) {
      points.insert(Kernel::Point_3(x, y, 0));
      points.insert(Kernel::Point_3(x, y, 100 + x));
    }
  for(int i = 0; i < 20; ++i)
    points.insert(Kernel::Point_3(2 * i, 2 * i, 20 + 3 * i));
  return points;
}

int main()
{
  Point_set points = make_points();
  std::cout << points.size() << " points\n";
  remove_outliers(points, 1.5, 2); // on the slope, neighbors are up to the root of 2 apart
  std::cout << points.size() << " points\n";
  remove_outliers(points, 1.5, 4); // borders; positions are no longer the indices of points
  std::cout << points.size() << " points\n";
}
