// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search by all processes, as the tables time it.

#ifndef THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_SEARCH_BY_PROCESSES_H
#define THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_SEARCH_BY_PROCESSES_H

#include "measuring/Tally.h"

#include <CGAL/distributed_fixed_radius_near_neighbors.h>

#include <mpi.h>

#include <cstdint>

namespace thick_benchmark {

// Returns the tally of the pairs that this process reports.
template <class Points>
Tally search_by_processes(const Points& points, double r, CGAL::Point_distribution distribution)
{
  Tally tally;
  CGAL::Distributed_profile profile(distribution);
  CGAL::distributed_fixed_radius_near_neighbors(
    MPI_COMM_WORLD, points, CGAL::within_distance(r),
    [&](std::uint64_t i, std::uint64_t j) { tally(i, j); }, profile);
  return tally;
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_SEARCH_BY_PROCESSES_H
