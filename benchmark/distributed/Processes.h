// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The processes of a measurement: their shares of a scene, times that all of them agree on, and the
// tables.

#ifndef THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_PROCESSES_H
#define THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_PROCESSES_H

#include "measuring/Tally.h"
#include "measuring/timing.h"
#include "scenes/Scene.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <thread>
#include <vector>

namespace thick_benchmark {

inline int rank()
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline int process_count()
{
  int count;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

inline double maximum(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

// Returns the pairs that all processes have found.
inline Tally sum(Tally tally)
{
  MPI_Allreduce(MPI_IN_PLACE, &tally.pairs, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &tally.positions, 1, MPI_UINT64_T, MPI_BXOR, MPI_COMM_WORLD);
  return tally;
}

inline Scene share_of(const Scene& scene)
{
  const auto place = [&](int rank) { // where the points of a process begin
    return scene.coordinates.begin()
           + static_cast<std::ptrdiff_t>(scene.size()) * rank / process_count() * scene.dimension;
  };
  return {scene.name, scene.dimension, {place(rank()), place(rank() + 1)}, scene.r};
}

// The same points by their first coordinates: the shares are slabs of space.
inline Scene in_slabs(const Scene& scene)
{
  std::vector<std::size_t> order(scene.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return *scene.point(i) < *scene.point(j); });
  Scene sorted = {scene.name, scene.dimension, {}, scene.r};
  sorted.coordinates.reserve(scene.coordinates.size());
  for(const std::size_t i : order)
    sorted.coordinates.insert(sorted.coordinates.end(), scene.point(i),
                              scene.point(i) + scene.dimension);
  return sorted;
}

// A job of all processes takes from when all of them begin until the last one is done.
template <class Function>
Job timed_on_all(const Function& function)
{
  return [function] {
    MPI_Barrier(MPI_COMM_WORLD);
    return maximum(seconds_of(function));
  };
}

// Waits for all processes, without taking the time of a processor.
inline void wait_asleep()
{
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for(int is_done = 0; !is_done;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
  }
}

// A job of the first process, while all others sleep.
template <class Function>
Job timed_on_first(const Function& function)
{
  return [function] {
    MPI_Barrier(MPI_COMM_WORLD);
    const double seconds = rank() == 0 ? seconds_of(function) : 0;
    wait_asleep();
    return maximum(seconds);
  };
}

// ---- tables: all processes call these functions together ----------------------------------------

// Two processes beside two threads of one process.
void print_threads(bool is_quick);

// The peak of memory, to be measured once in a process.
void print_memory(bool is_quick);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_PROCESSES_H
