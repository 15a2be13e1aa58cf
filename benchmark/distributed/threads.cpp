// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Two processes of one machine beside two threads of one process. What the machine has to give is
// told by two searches of half of the points each, which have nothing to do with each other.

#include "Processes.h"

#include "scenes/generators.h"
#include "table/print.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

namespace thick_benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void check(const Tally& found, std::uint64_t pairs)
{
  if(found.pairs != pairs)
    throw std::runtime_error("the pairs are not those of one process");
}

template <class Points>
Tally search(const Points& points, double r)
{
  Tally tally;
  CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(r), std::ref(tally));
  return tally;
}

template <class Points>
Tally search_by_threads(const Points& points, double r)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Parallel_tally tally;
  CGAL::fixed_radius_near_neighbors<CGAL::Parallel_tag>(points, CGAL::within_distance(r), tally);
  return tally.sum();
#else
  return search(points, r);
#endif
}

// Returns the tally of the pairs that this process reports.
template <class Points>
Tally search_by_processes(const Points& points, double r, CGAL::Point_distribution distribution)
{
  Tally tally;
  CGAL::Distributed_profile profile(distribution);
  CGAL::distributed_fixed_radius_near_neighbors(
    MPI_COMM_WORLD, points, CGAL::within_distance(r),
    [&](std::uint64_t i, std::uint64_t j) { tally(i, j); }, profile);
  return tally;
}

template <int Dimension>
void print_row(std::size_t n)
{
  const auto k = [](std::size_t count) { return 4 * static_cast<double>(count); };
  const Scene scene = uniform(Dimension, n, k(n));
  const Scene none = {"", Dimension, {}, 0};
  const auto all = make_points<Kernel, Dimension>(rank() == 0 ? scene : none);
  const auto own = make_points<Kernel, Dimension>(share_of(scene));
  const auto slab = make_points<Kernel, Dimension>(share_of(in_slabs(scene)));
  const Scene half_scene = uniform(Dimension, n / 2, k(n / 2));
  const auto half = make_points<Kernel, Dimension>(half_scene);
  std::uint64_t pairs = search(all, scene.r).pairs;
  MPI_Bcast(&pairs, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);

  using Distribution = CGAL::Point_distribution;
  const auto distributed = [&](const auto& points, Distribution distribution) {
    return [&, distribution] {
      check(sum(search_by_processes(points, scene.r, distribution)), pairs);
    };
  };
  const std::vector<Seconds> times = time_in_turns(
    {timed_on_first([&] { check(search(all, scene.r), pairs); }),
     timed_on_first([&] { check(search_by_threads(all, scene.r), pairs); }),
     timed_on_all(distributed(own, Distribution::BALANCED)),
     timed_on_all(distributed(slab, Distribution::AS_IS)),
     timed_on_all([&] { search(half, half_scene.r); })},
    5);
  if(rank() != 0)
    return;
  const auto milliseconds = [&](std::size_t job) {
    return fixed(1000 * median(times, [&](const Seconds& s) { return s[job]; }), 1);
  };
  const auto quotient = [&](std::size_t a, std::size_t b) {
    return fixed(median(times, [&](const Seconds& s) { return s[a] / s[b]; }), 2);
  };
  print_line(scene.name, n, pairs, milliseconds(0), milliseconds(1), milliseconds(2),
             milliseconds(3), quotient(0, 4), quotient(0, 1), quotient(0, 2), quotient(0, 3),
             quotient(2, 1));
}

} // namespace

void print_threads(bool is_quick)
{
  if(process_count() != 2)
    throw std::runtime_error("two processes are to be started");
  if(rank() == 0) {
    std::cout << '\n';
    print_head({"scene", ">n", ">k", ">ms of 1 process", ">of 2 threads", ">of 2 processes",
                ">of 2, as is", ">machine", ">2 threads", ">2 processes", ">2, as is",
                ">processes / threads"});
  }
  for(const std::size_t n : {1000000, 4000000}) {
    print_row<2>(is_quick ? n / 100 : n);
    print_row<3>(is_quick ? n / 100 : n);
  }
}

} // namespace thick_benchmark
