// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_GATHER_ALL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_GATHER_ALL_H

// What each process has, on all processes.

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the values of all processes, one process after another. They are those of small samples.
template <class Value>
std::vector<Value> gather_all(const Communicator& comm, const std::vector<Value>& mine)
{
  std::vector<std::uint64_t> counts;
  std::vector<int> sizes, begins;
  std::vector<Value> all;
  run_together(comm, [&] { counts.resize(static_cast<std::size_t>(comm.size())); });
  const std::uint64_t count = mine.size() * sizeof(Value);
  comm.gather(&count, 1, counts);
  run_together(comm, [&] {
    std::uint64_t begin = 0;
    for(const std::uint64_t size : counts) {
      sizes.push_back(static_cast<int>(size));
      begins.push_back(static_cast<int>(begin));
      begin += size;
      if(begin > (std::numeric_limits<int>::max)())
        throw std::length_error("There are too many processes for one sample.");
    }
    all.resize(static_cast<std::size_t>(begin / sizeof(Value)));
  });
  MPI_Allgatherv(mine.data(), static_cast<int>(count), MPI_BYTE, all.data(), sizes.data(),
                 begins.data(), MPI_BYTE, comm.get());
  return all;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_GATHER_ALL_H
