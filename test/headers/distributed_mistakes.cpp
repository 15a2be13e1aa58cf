// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls by several processes that do not compile. Otherwise as mistakes.cpp.

#include <CGAL/Exact_rational.h>
#include <CGAL/Root_of_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Root_kernel = CGAL::Simple_cartesian<CGAL::Root_of_traits<CGAL::Exact_rational>::Root_of_2>;

const std::vector<Point> points;
const std::vector<std::array<double, 2>> arrays;
const std::vector<Root_kernel::Point_2> points_of_roots;
const auto bound = CGAL::within_distance(1);
const auto report = [](std::size_t, std::size_t) {};

void make_mistakes()
{
  // error: The elements of other processes are not here: the callback must take two ids
  // (std::uint64_t i, std::uint64_t j).
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, points, bound,
                                                CGAL::with_elements([](Point, Point) {}));

  // error: Points are sent to other processes as rational numbers: the coordinates must be of a
  // rational number type.
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, points_of_roots, bound, report);

  // error: The elements of the range must be points of a kernel of CGAL: pass a property map
  // to such points as point_map.
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, arrays, bound, report);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, points, 1.0, report);

  // error: The bound must be within_distance(r) or within_squared_distance(r2), not a bare
  // number.
  CGAL::distributed_fixed_radius_neighbor_lists(MPI_COMM_WORLD, points, points, 1);
}
