// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_GATHER_BYTES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_GATHER_BYTES_H

// Gives the bytes of each process to all of them.

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

// Returns the bytes of all processes, one process after another. They are those of small samples.
inline std::vector<char> gather_bytes(const Communicator& comm, const std::vector<char>& mine)
{
  std::vector<std::uint64_t> counts;
  std::vector<int> sizes, begins;
  std::vector<char> all;
  run_together(comm, [&] { counts.resize(static_cast<std::size_t>(comm.size())); });
  const std::uint64_t count = mine.size();
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
    all.resize(static_cast<std::size_t>(begin));
  });
  MPI_Allgatherv(mine.data(), static_cast<int>(mine.size()), MPI_BYTE, all.data(), sizes.data(),
                 begins.data(), MPI_BYTE, comm.get());
  return all;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_GATHER_BYTES_H
