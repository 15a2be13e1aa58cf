// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Begins and ends MPI for a program of tests that several processes run.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_MPI_FIXTURE_H
#define THICK_INTERSECTION_TEST_SUPPORT_MPI_FIXTURE_H

#include "unit_test.h"

#include <mpi.h>

namespace test_support {

struct Mpi_fixture
{
  Mpi_fixture()
  {
    int provided;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  }
  ~Mpi_fixture() { MPI_Finalize(); }
};
BOOST_TEST_GLOBAL_FIXTURE(Mpi_fixture);

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_MPI_FIXTURE_H
