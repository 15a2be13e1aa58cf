// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The signal that stops all processes.

#include "support/mpi_fixture.h"

#include <CGAL/Thick_intersection_d/internal/distributed/Stop_signal.h>

BOOST_AUTO_TEST_SUITE(Stop_signal)

using namespace test_support;

BOOST_AUTO_TEST_CASE(a_signal_reaches_all_other_processes)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  for(int first = 0; first < comm.size(); ++first) {
    internal::Stop_signal signal(comm);
    if(comm.rank() == first)
      signal.raise();
    else
      while(!signal.has_arrived()) {
      }
    BOOST_CHECK_EQUAL(signal.was_received(), comm.rank() != first);
    BOOST_CHECK(signal.finish());
  }
}

BOOST_AUTO_TEST_CASE(without_a_signal_nothing_arrives)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  internal::Stop_signal signal(comm);
  BOOST_CHECK(!signal.has_arrived());
  BOOST_CHECK(!signal.finish());
}

// Nobody has looked for the messages before the end.
BOOST_AUTO_TEST_CASE(no_message_is_left_for_the_next_search)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  for(int count = 1; count <= comm.size(); ++count) {
    internal::Stop_signal signal(comm);
    if(comm.rank() < count)
      signal.raise();
    BOOST_CHECK(signal.finish());
    MPI_Barrier(MPI_COMM_WORLD);
    internal::Stop_signal next(comm);
    for(int i = 0; i < 100; ++i)
      BOOST_CHECK(!next.has_arrived());
    BOOST_CHECK(!next.finish());
  }
}

BOOST_AUTO_TEST_SUITE_END()
