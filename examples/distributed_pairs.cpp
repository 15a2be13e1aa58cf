// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points on several processes of MPI: each process has some layers of a lattice, and counts the
// pairs that it finds. Then it gets the neighbors of its points. Run it as:
// mpirun -n 4 distributed_pairs

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>
#include <mpi.h>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main(int argc, char* argv[])
{
  MPI_Init(&argc, &argv);
  int rank, size;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);

  std::vector<Point_3> points;
  for(int z = rank; z < 40; z += size)
    for(int y = 0; y < 40; ++y)
      for(int x = 0; x < 40; ++x)
        points.emplace_back(x, y, z);

  int status = EXIT_SUCCESS;
  try {
    std::uint64_t count = 0;
    CGAL::distributed_fixed_radius_near_neighbors(
      MPI_COMM_WORLD, points, CGAL::within_distance(1),
      [&](std::uint64_t, std::uint64_t) { ++count; });

    std::uint64_t sum = 0;
    MPI_Reduce(&count, &sum, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
    const CGAL::Distributed_neighbor_lists lists = CGAL::distributed_fixed_radius_neighbor_lists(
      MPI_COMM_WORLD, points, CGAL::within_distance(1));
    if(rank == 0)
      std::cout << sum << " pairs on " << size << " processes\n"
                << lists[0].size() << " neighbors of the first point\n";
  }
  catch(const std::exception& error) { // on all processes, if it is thrown on one
    std::cerr << error.what() << '\n';
    status = EXIT_FAILURE;
  }
  MPI_Finalize();
  return status;
}
