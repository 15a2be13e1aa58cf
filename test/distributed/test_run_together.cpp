// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// If a process throws, all processes throw.

#include "support/mpi_fixture.h"

#include <CGAL/Thick_intersection_d/internal/distributed/run_together.h>

BOOST_AUTO_TEST_SUITE(run_together)

using namespace test_support;

// Checks that the processes for which throws(rank) is true throw their own exception, and that all
// others throw that of the first one.
template <class Throws>
void check_throwing(const Throws& throws, const std::string& text)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  int first = 0;
  while(first < comm.size() && !throws(first))
    ++first;
  const auto run = [&] {
    internal::run_together(comm, [&] {
      if(throws(comm.rank()))
        throw std::domain_error(text);
    });
  };
  if(throws(comm.rank()))
    BOOST_CHECK_THROW(run(), std::domain_error);
  else if(first < comm.size())
    BOOST_CHECK_EXCEPTION(run(), CGAL::Remote_error, [&](const CGAL::Remote_error& error) {
      const std::string prefix = "Rank " + std::to_string(first) + ": " + text.substr(0, 1023);
      return error.rank() == first && error.what() == prefix;
    });
  else
    run();
}

BOOST_AUTO_TEST_CASE(others_throw_the_exception_of_the_first_process_that_throws)
{
  check_throwing([](int) { return false; }, "none");
  check_throwing([](int) { return true; }, "all");
  check_throwing([](int rank) { return rank == 0; }, "the first");
  check_throwing([](int rank) { return rank == 1; }, "the second");
  check_throwing([](int rank) { return rank >= 2; }, "some");
}

BOOST_AUTO_TEST_CASE(long_messages_are_cut)
{
  check_throwing([](int rank) { return rank == 1; }, std::string(5000, 'x'));
}

BOOST_AUTO_TEST_CASE(anything_can_be_thrown)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  const auto run = [&] {
    internal::run_together(comm, [&] {
      if(comm.rank() == 0)
        throw 5;
    });
  };
  if(comm.rank() == 0)
    BOOST_CHECK_THROW(run(), int);
  else
    BOOST_CHECK_THROW(run(), CGAL::Remote_error);
}

BOOST_AUTO_TEST_CASE(texts_that_differ_on_any_process_are_refused_on_all)
{
  const internal::Communicator comm(MPI_COMM_WORLD);
  internal::agree_on(comm, "The text", "same");
  internal::agree_on(comm, "The text", "");
  for(int other = 1; other < comm.size(); ++other)
    for(const std::string text : {"", "samf", "sam", "same as"})
      BOOST_CHECK_THROW(internal::agree_on(comm, "The text", comm.rank() == other ? text : "same"),
                        std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
