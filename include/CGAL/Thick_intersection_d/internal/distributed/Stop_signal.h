// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_STOP_SIGNAL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_STOP_SIGNAL_H

// Stops the search on all processes when it stops on one of them.

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>

#include <mpi.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A process that stops sends an empty message to each other process. All others look for messages
// from time to time. In the end, all messages are received, so that none is left in flight.
class Stop_signal
{
public:
  explicit Stop_signal(const Communicator& comm)
    : comm_(comm), requests_(static_cast<std::size_t>(comm.size()), MPI_REQUEST_NULL),
      received_(requests_.size()), raised_(requests_.size())
  {}

  // Returns whether a message has arrived. Any thread of a search may ask, one at a time.
  bool has_arrived()
  {
    if(!has_arrived_ && may_call_mpi()) {
      int is_there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, tag, comm_.get(), &is_there, &status);
      if(is_there)
        receive(status.MPI_SOURCE);
    }
    return has_arrived_;
  }

  bool was_received() const { return has_arrived_; }

  // Sends the messages.
  void raise()
  {
    is_raised_ = 1;
    for(int rank = 0; rank < comm_.size(); ++rank)
      if(rank != comm_.rank())
        MPI_Isend(nullptr, 0, MPI_BYTE, rank, tag, comm_.get(),
                  &requests_[static_cast<std::size_t>(rank)]);
  }

  // Receives all messages that are still on their way. Collective. Returns whether a process has
  // sent some.
  bool finish()
  {
    comm_.gather(&is_raised_, 1, raised_);
    bool is_raised = false;
    for(int rank = 0; rank < comm_.size(); ++rank)
      if(raised_[static_cast<std::size_t>(rank)]) {
        is_raised = true;
        if(rank != comm_.rank() && !received_[static_cast<std::size_t>(rank)])
          receive(rank);
      }
    MPI_Waitall(comm_.size(), requests_.data(), MPI_STATUSES_IGNORE);
    return is_raised;
  }

private:
  static constexpr int tag = 1;

  // A thread of a parallel search may be none that MPI was initialized for.
  static bool may_call_mpi()
  {
    int provided = MPI_THREAD_SINGLE;
    MPI_Query_thread(&provided);
    int is_main = 0;
    MPI_Is_thread_main(&is_main);
    return provided >= MPI_THREAD_SERIALIZED || is_main;
  }

  void receive(int rank)
  {
    MPI_Recv(nullptr, 0, MPI_BYTE, rank, tag, comm_.get(), MPI_STATUS_IGNORE);
    received_[static_cast<std::size_t>(rank)] = 1;
    has_arrived_ = true;
  }

  const Communicator& comm_;
  std::vector<MPI_Request> requests_; // of the messages sent
  std::vector<char> received_;        // from which processes messages were received
  std::vector<char> raised_;          // which processes have sent messages
  char is_raised_ = 0;
  bool has_arrived_ = false;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_STOP_SIGNAL_H
