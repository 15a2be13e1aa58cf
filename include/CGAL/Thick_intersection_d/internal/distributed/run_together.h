// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H

// If a process throws, all processes throw.

#include <CGAL/Remote_error.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <exception>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

using Error_message = std::array<char, 1024>;

// Returns what an exception says, cut to the length of messages.
inline Error_message message_of(const std::exception_ptr& error)
{
  Error_message message{};
  const auto copy = [&](const char* text) {
    std::memcpy(message.data(), text, (std::min)(std::strlen(text), message.size() - 1));
  };
  try {
    std::rethrow_exception(error);
  }
  catch(const std::exception& known) {
    copy(known.what());
  }
  catch(...) {
    copy("an exception that is not a std::exception");
  }
  return message;
}

// Throws on all processes if `error` is not null on one of them: there the error itself, elsewhere
// a `Remote_error` with the message of the first such process. Allocates nothing before.
inline void throw_together(const Communicator& comm, const std::exception_ptr& error)
{
  const int first = comm.least(error ? comm.rank() : comm.size());
  if(first == comm.size())
    return;
  Error_message message{};
  if(comm.rank() == first)
    message = message_of(error);
  MPI_Bcast(message.data(), static_cast<int>(message.size()), MPI_CHAR, first, comm.get());
  if(error)
    std::rethrow_exception(error);
  throw Remote_error(first, message.data());
}

// Runs a task that does not communicate. If it throws on one process, all processes throw.
template <class Task>
void run_together(const Communicator& comm, const Task& task)
{
  std::exception_ptr error;
  try {
    task();
  }
  catch(...) {
    error = std::current_exception();
  }
  throw_together(comm, error);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H
