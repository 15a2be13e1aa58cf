// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Intersecting pairs of objects of a kernel, of balls, and between two sets.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Thick_ball_traits_d.h>
#include <CGAL/thick_intersection_d.h>
#include <iostream>
#include <vector>

int main()
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  const auto print = [](std::size_t i, std::size_t j) { std::cout << i << ' ' << j << '\n'; };

  std::cout << "crossing segments\n";
  const std::vector<Kernel::Segment_2> segments = {{Point(0, 0), Point(2, 2)},
                                                   {Point(0, 2), Point(2, 0)},
                                                   {Point(5, 0), Point(6, 0)}};
  CGAL::thick_self_intersection_d(segments, print);

  std::cout << "overlapping balls\n"; // a center and a radius
  const std::vector<std::pair<Point, double>> balls = {{Point(0, 0), 2.},
                                                       {Point(3, 0), 1.},
                                                       {Point(0, 1), 0.5}};
  CGAL::thick_self_intersection_d(
    balls, print, CGAL::parameters::geom_traits(CGAL::Thick_ball_traits_d<Point>(balls)));

  std::cout << "segments of one set and of another\n";
  const std::vector<Kernel::Segment_2> others = {{Point(5.5, -1), Point(5.5, 1)}};
  CGAL::thick_intersection_d(segments, others, print);
}
