// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_AGREE_ON_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_AGREE_ON_H

// Checks that all processes were given the same.

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>

#include <mpi.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Throws std::invalid_argument on all processes if their texts differ. `what` names them: a string
// would be made before this function can tell others that it could not.
inline void agree_on(const Communicator& comm, const char* what, const std::string& text)
{
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, comm.get());
  std::string first;
  run_together(comm, [&] {
    first = text;
    first.resize(static_cast<std::string::size_type>(size));
  });
  MPI_Bcast(&first[0], static_cast<int>(size), MPI_CHAR, 0, comm.get());
  const int other = comm.least(first == text ? comm.size() : comm.rank());
  if(other < comm.size())
    throw std::invalid_argument(std::string(what) + " of rank " + std::to_string(other)
                                + " differs from that of rank 0.");
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_AGREE_ON_H
