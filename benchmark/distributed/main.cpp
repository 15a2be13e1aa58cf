// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The distributed search, on processes of one machine. Prints rows of a table in Markdown,
// and its head with the least number of processes. scripts/benchmark runs it with all numbers.
//
//   mpiexec -n <processes> distributed_table <table> [--quick]
//
//   threads    two processes beside two threads of one process
//   memory     the peak of memory
//
// It ends with status 1 if pairs are not those of one process.

#include "Processes.h"

#include <mpi.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace thick_benchmark {
namespace {

void print_rows(const std::string& table, bool is_quick)
{
  if(table == "threads")
    print_threads(is_quick);
  else if(table == "memory")
    print_memory(is_quick);
  else
    throw std::invalid_argument("there is no table of this name");
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char* argv[])
{
  MPI_Init(&argc, &argv);
  try {
    const bool is_quick = argc > 2 && argv[2] == std::string("--quick");
    thick_benchmark::print_rows(argc > 1 ? argv[1] : "", is_quick);
  }
  catch(const std::exception& error) {
    std::cerr << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  }
  MPI_Finalize();
}
