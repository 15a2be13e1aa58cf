// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H

// What processes do together: if one of them throws, all of them throw. They send each other bytes.

#include <CGAL/Remote_error.h>
#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/machine/huge_pages.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <numeric>
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

// The bytes for each process, or from each process.
using Bytes_of_ranks = std::vector<std::vector<char>>;

// Counts of MPI are below 2^31, so longer messages go in chunks.
inline constexpr std::size_t max_chunk_size = std::size_t(1) << 30;

// Each step of an exchange waits for the slowest process.
inline constexpr int max_exchange_steps = 8;

// Sends bytes to any processes, and takes what they send.
//
// In each step, a process sends to some of the processes behind it, and receives from as many that
// are before it. What it has sent is given back, and what it has received is taken, before the next
// step. So it holds a part of the messages at a time. Nothing is allocated while messages are in
// flight. Chunks between two processes arrive in the order in which they were sent.
class Byte_exchange
{
public:
  // Tells all processes how much they will receive. Collective.
  Byte_exchange(const Communicator& comm, Bytes_of_ranks& outgoing,
                std::size_t chunk_size = max_chunk_size, int max_steps = max_exchange_steps)
    : comm_(comm), outgoing_(outgoing), chunk_size_(chunk_size),
      width_((comm.size() - 1 + max_steps - 1) / max_steps)
  {
    run_together(comm, [&] {
      for(const std::vector<char>& bytes : outgoing)
        sizes_sent_.push_back(bytes.size());
      sizes_.resize(outgoing.size());
    });
    MPI_Alltoall(sizes_sent_.data(), 1, MPI_UINT64_T, sizes_.data(), 1, MPI_UINT64_T, comm.get());
    run_together(comm, [&] { make_room(); });
  }

  // Returns how many bytes are sent to this process, by itself as well.
  std::uint64_t incoming_size() const
  {
    return std::accumulate(sizes_.begin(), sizes_.end(), std::uint64_t(0));
  }

  // Returns how many bytes this process sends to others.
  std::uint64_t outgoing_size() const
  {
    return std::accumulate(sizes_sent_.begin(), sizes_sent_.end(), std::uint64_t(0))
           - sizes_sent_[place(comm_.rank())];
  }

  // Calls take(rank, bytes) with what each process has sent to this one. If it throws on one
  // process, all processes throw. Collective.
  template <class Take>
  void run(const Take& take)
  {
    std::vector<char>& own = outgoing_[place(comm_.rank())];
    run_together(comm_, [&] { take(place(comm_.rank()), own); });
    own = std::vector<char>();
    for(int first = 1; first < comm_.size(); first += width_) {
      const int last = (std::min)(first + width_, comm_.size());
      send_and_receive(first, last);
      run_together(comm_, [&] {
        for(int distance = first; distance < last; ++distance)
          take(source(distance), incoming_[place(distance - first)]);
      });
    }
  }

private:
  static constexpr int tag = 0;

  static std::size_t place(int rank) { return static_cast<std::size_t>(rank); }
  std::size_t source(int distance) const
  {
    return place((comm_.rank() - distance + comm_.size()) % comm_.size());
  }
  std::size_t target(int distance) const
  {
    return place((comm_.rank() + distance) % comm_.size());
  }

  std::size_t chunk_count(std::uint64_t size) const
  {
    return static_cast<std::size_t>((size + chunk_size_ - 1) / chunk_size_);
  }

  // Makes room for the largest message of all steps, so that `send_and_receive` need not allocate.
  void make_room()
  {
    incoming_.resize(place(width_));
    std::size_t chunks = 0;
    for(int distance = 1; distance < comm_.size(); ++distance) {
      const std::uint64_t size = sizes_[source(distance)];
      std::vector<char>& bytes = incoming_[place((distance - 1) % width_)];
      bytes.reserve(static_cast<std::size_t>(size));
      advise_huge_pages(bytes.data(), bytes.capacity());
      chunks += chunk_count(size) + chunk_count(sizes_sent_[target(distance)]);
    }
    requests_.reserve(chunks);
  }

  // Calls post(bytes, size, request) for the chunks of a message.
  template <class Post>
  void for_each_chunk(std::vector<char>& bytes, const Post& post)
  {
    for(std::size_t begin = 0; begin < bytes.size(); begin += chunk_size_) {
      requests_.push_back(MPI_REQUEST_NULL);
      post(bytes.data() + begin,
           static_cast<int>((std::min)(chunk_size_, bytes.size() - begin)), &requests_.back());
    }
  }

  void send_and_receive(int first, int last)
  {
    requests_.clear();
    for(int distance = first; distance < last; ++distance) {
      const std::size_t rank = source(distance);
      std::vector<char>& bytes = incoming_[place(distance - first)];
      bytes.resize(static_cast<std::size_t>(sizes_[rank]));
      for_each_chunk(bytes, [&](char* chunk, int size, MPI_Request* request) {
        MPI_Irecv(chunk, size, MPI_BYTE, static_cast<int>(rank), tag, comm_.get(), request);
      });
    }
    for(int distance = first; distance < last; ++distance) {
      const std::size_t rank = target(distance);
      for_each_chunk(outgoing_[rank], [&](char* chunk, int size, MPI_Request* request) {
        MPI_Isend(chunk, size, MPI_BYTE, static_cast<int>(rank), tag, comm_.get(), request);
      });
    }
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    for(int distance = first; distance < last; ++distance)
      outgoing_[target(distance)] = std::vector<char>();
  }

  const Communicator& comm_;
  Bytes_of_ranks& outgoing_;
  const std::size_t chunk_size_;
  const int width_; // how many messages a process receives in a step
  std::vector<std::uint64_t> sizes_sent_; // of the messages to each process
  std::vector<std::uint64_t> sizes_;      // of those from each process
  Bytes_of_ranks incoming_;               // of one step
  std::vector<MPI_Request> requests_;     // of one step
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DISTRIBUTED_RUN_TOGETHER_H
