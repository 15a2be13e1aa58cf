// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_EXCHANGE_BYTES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_EXCHANGE_BYTES_H

// Sends bytes to any processes, and receives what they send.

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The bytes for each process, or from each process.
using Bytes_of_ranks = std::vector<std::vector<char>>;

// Counts of MPI are below 2^31, so longer messages go in chunks.
inline constexpr std::size_t max_chunk_size = std::size_t(1) << 30;

// Calls post(rank, begin, size) for the chunks of each process.
template <class Post>
void for_each_chunk(Bytes_of_ranks& bytes, std::size_t chunk_size, const Post& post)
{
  for(std::size_t rank = 0; rank < bytes.size(); ++rank)
    for(std::size_t begin = 0; begin < bytes[rank].size(); begin += chunk_size)
      post(static_cast<int>(rank), bytes[rank].data() + begin,
           static_cast<int>((std::min)(chunk_size, bytes[rank].size() - begin)));
}

// Returns what the processes have sent to this one. Nothing is allocated while messages are in
// flight. Chunks between two processes arrive in the order in which they were sent. What a process
// sends to itself is moved.
inline Bytes_of_ranks exchange_bytes(const Communicator& comm, Bytes_of_ranks& outgoing,
                                     std::size_t chunk_size = max_chunk_size)
{
  const std::size_t count = outgoing.size();
  std::vector<char> own = std::exchange(outgoing[static_cast<std::size_t>(comm.rank())], {});
  std::vector<std::uint64_t> sent, received;
  Bytes_of_ranks incoming;
  std::vector<MPI_Request> requests;
  run_together(comm, [&] {
    for(const std::vector<char>& bytes : outgoing)
      sent.push_back(bytes.size());
    received.resize(count);
    incoming.resize(count);
  });
  MPI_Alltoall(sent.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T, comm.get());
  run_together(comm, [&] {
    std::size_t chunks = 0;
    for(std::size_t rank = 0; rank < count; ++rank) {
      incoming[rank].resize(static_cast<std::size_t>(received[rank]));
      chunks += incoming[rank].size() / chunk_size + outgoing[rank].size() / chunk_size + 2;
    }
    requests.reserve(chunks);
  });
  const auto new_request = [&] {
    requests.push_back(MPI_REQUEST_NULL);
    return &requests.back();
  };
  for_each_chunk(incoming, chunk_size, [&](int rank, char* bytes, int size) {
    MPI_Irecv(bytes, size, MPI_BYTE, rank, 0, comm.get(), new_request());
  });
  for_each_chunk(outgoing, chunk_size, [&](int rank, char* bytes, int size) {
    MPI_Isend(bytes, size, MPI_BYTE, rank, 0, comm.get(), new_request());
  });
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  own.swap(incoming[static_cast<std::size_t>(comm.rank())]);
  return incoming;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_EXCHANGE_BYTES_H
