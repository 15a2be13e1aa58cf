// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H

// What processes do together: if one of them throws, all of them throw.

#include <CGAL/Remote_error.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

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

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H
