// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The duplicate of a communicator that a search works on.

#include "support/mpi_fixture.h"

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>

BOOST_AUTO_TEST_SUITE(Communicator)

using namespace test_support;

BOOST_AUTO_TEST_CASE(communicators_between_two_groups_are_refused)
{
  int rank, size;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if(size == 1)
    return;
  const int is_first = rank == 0;
  MPI_Comm group, both;
  MPI_Comm_split(MPI_COMM_WORLD, is_first, rank, &group);
  MPI_Intercomm_create(group, 0, MPI_COMM_WORLD, is_first ? 1 : 0, 0, &both);
  BOOST_CHECK_THROW(internal::Communicator refused(both), std::invalid_argument);
  MPI_Comm_free(&both);
  MPI_Comm_free(&group);
}

BOOST_AUTO_TEST_CASE(messages_of_the_user_are_left_alone)
{
  char mine = 7, received = 0;
  MPI_Request request;
  int rank, size;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  MPI_Isend(&mine, 1, MPI_CHAR, (rank + 1) % size, 1, MPI_COMM_WORLD, &request);
  {
    const internal::Communicator comm(MPI_COMM_WORLD);
    BOOST_CHECK_EQUAL(comm.rank(), rank);
    BOOST_CHECK_EQUAL(comm.size(), size);
    comm.least(rank); // now all messages are on their way
    int is_there = 1;
    MPI_Iprobe(MPI_ANY_SOURCE, 1, comm.get(), &is_there, MPI_STATUS_IGNORE);
    BOOST_CHECK(!is_there);
  }
  MPI_Recv(&received, 1, MPI_CHAR, (rank + size - 1) % size, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
  BOOST_CHECK_EQUAL(received, mine);
}

// A search has no way to go on after an error of MPI, and says so in the manual.
BOOST_AUTO_TEST_CASE(errors_end_the_job_whatever_the_user_wants)
{
  MPI_Comm lenient;
  MPI_Comm_dup(MPI_COMM_WORLD, &lenient);
  MPI_Comm_set_errhandler(lenient, MPI_ERRORS_RETURN);
  {
    const internal::Communicator comm(lenient);
    MPI_Errhandler handler;
    MPI_Comm_get_errhandler(comm.get(), &handler);
    BOOST_CHECK(handler == MPI_ERRORS_ARE_FATAL);
  }
  MPI_Comm_free(&lenient);
}

BOOST_AUTO_TEST_SUITE_END()
