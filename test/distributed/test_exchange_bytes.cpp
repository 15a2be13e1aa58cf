// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What processes send to each other, or to all.

#include "support/mpi_fixture.h"

#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>

BOOST_AUTO_TEST_SUITE(exchange_bytes)

using namespace test_support;

// What a process sends to another one. Some send nothing.
std::vector<char> message(int from, int to)
{
  std::vector<char> bytes(static_cast<std::size_t>(100 * (from + to)));
  for(std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(i + static_cast<std::size_t>(3 * from + to));
  return bytes;
}

internal::Bytes_of_ranks messages_from(const internal::Communicator& comm)
{
  internal::Bytes_of_ranks messages;
  for(int r = 0; r < comm.size(); ++r)
    messages.push_back(message(comm.rank(), r));
  return messages;
}

BOOST_AUTO_TEST_CASE(messages_of_any_length_arrive_in_chunks_of_any_size_and_steps_of_any_number)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  for(const std::size_t chunk_size : {std::size_t(1), std::size_t(7), std::size_t(100),
                                      internal::max_chunk_size})
    for(const int max_steps : {1, 2, 4, internal::max_exchange_steps}) {
      internal::Bytes_of_ranks outgoing = messages_from(comm);
      internal::Byte_exchange exchange(comm, outgoing, chunk_size, max_steps);
      internal::Bytes_of_ranks incoming(outgoing.size());
      const auto own = static_cast<std::size_t>(comm.rank());
      std::size_t calls = 0, size = 0;
      exchange.run([&](std::size_t rank, const std::vector<char>& bytes) {
        incoming[rank] = bytes;
        ++calls;
      });
      for(int r = 0; r < comm.size(); ++r) {
        BOOST_CHECK(incoming[static_cast<std::size_t>(r)] == message(r, comm.rank()));
        BOOST_CHECK_EQUAL(outgoing[static_cast<std::size_t>(r)].capacity(), 0);
        size += incoming[static_cast<std::size_t>(r)].size();
      }
      BOOST_CHECK_EQUAL(calls, incoming.size());
      BOOST_CHECK_EQUAL(exchange.incoming_size(), size);
      BOOST_CHECK_EQUAL(exchange.outgoing_size(), size - incoming[own].size()); // by symmetry
    }
}

BOOST_AUTO_TEST_CASE(all_processes_throw_if_one_cannot_take_what_it_has_received)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  for(int thrower = 0; thrower < comm.size(); ++thrower)
    for(std::size_t source = 0; source < static_cast<std::size_t>(comm.size()); ++source) {
      internal::Bytes_of_ranks outgoing = messages_from(comm);
      internal::Byte_exchange exchange(comm, outgoing);
      const auto take = [&](std::size_t rank, const std::vector<char>&) {
        if(comm.rank() == thrower && rank == source)
          throw std::domain_error("cannot be taken");
      };
      if(comm.rank() == thrower)
        BOOST_CHECK_THROW(exchange.run(take), std::domain_error);
      else
        BOOST_CHECK_THROW(exchange.run(take), CGAL::Remote_error);
    }
}

// To be run by two processes with --run_test=*/messages_beyond_2_31_bytes_arrive, which needs 6 GB.
BOOST_AUTO_TEST_CASE(messages_beyond_2_31_bytes_arrive, *boost::unit_test::disabled())
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  const std::size_t size = (std::size_t(1) << 31) + (std::size_t(1) << 29) + 12345;
  const auto byte_at = [](std::size_t i) { return static_cast<char>(i % 251); };
  internal::Bytes_of_ranks outgoing(static_cast<std::size_t>(comm.size()));
  if(comm.rank() == 0) {
    outgoing.back().resize(size);
    for(std::size_t i = 0; i < size; ++i)
      outgoing.back()[i] = byte_at(i);
  }
  internal::Bytes_of_ranks incoming(outgoing.size());
  internal::Byte_exchange(comm, outgoing).run([&](std::size_t rank, std::vector<char>& bytes) {
    incoming[rank].swap(bytes);
  });
  const std::vector<char>& received = incoming.front();
  BOOST_CHECK_EQUAL(received.size(), comm.rank() + 1 == comm.size() ? size : 0);
  std::size_t wrong = 0;
  for(std::size_t i = 0; i < received.size(); ++i)
    wrong += received[i] != byte_at(i);
  BOOST_CHECK_EQUAL(wrong, 0);
}

BOOST_AUTO_TEST_CASE(all_processes_get_the_values_of_all_in_the_order_of_ranks)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  const auto values_of = [](int rank) { return std::vector<double>(3 * rank % 5, rank + .5); };
  std::vector<double> expected;
  for(int r = 0; r < comm.size(); ++r)
    for(const double value : values_of(r))
      expected.push_back(value);
  BOOST_CHECK(internal::gather_all(comm, values_of(comm.rank())) == expected);
}

BOOST_AUTO_TEST_SUITE_END()
