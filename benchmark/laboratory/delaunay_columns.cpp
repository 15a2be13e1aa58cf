// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Search in Delaunay triangulations: CGAL's own in the plane, breadth first in space, where CGAL
// has none. Both compare with the square of r as the number type of the kernel has it.

#include "columns.h"

#include "methods/delaunay.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace lab {
namespace {

template <class Kernel>
Run<Found> by_delaunay(const Scene& scene)
{
  const auto in_plane = [r = scene.r](const auto& points, Found& found) {
    delaunay_circle_search<Kernel>(points, r, found);
  };
  const auto in_space = [r = scene.r](const auto& points, Found& found) {
    const typename Kernel::FT radius(r);
    const typename Kernel::FT square = radius * radius;
    const auto is_near = [&](std::size_t i, std::size_t j) {
      return CGAL::compare_squared_distance(points[i], points[j], square) != CGAL::LARGER;
    };
    delaunay_search<Kernel>(points, is_near, found);
  };
  return scene.dimension == 2 ? run_on_points_d<Found, Kernel, 2>(scene, in_plane)
                              : run_on_points_d<Found, Kernel, 3>(scene, in_space);
}

} // namespace

Columns delaunay_columns()
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
  return {{{"Delaunay EPICK", by_delaunay<Epick>}, "library"},
          {{"Delaunay EPECK", by_delaunay<Epeck>}, "library"}};
}

} // namespace lab
