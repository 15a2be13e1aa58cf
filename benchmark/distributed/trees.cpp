// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The distributed search beside the distributed tree of ArborX, in space.

#include "Processes.h"
#include "search_by_processes.h"
#include "tables.h"

#include "scenes/generators.h"
#include "table/print.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>
#include <CGAL/fixed_radius_near_neighbors.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace thick_benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Returns the scene with a distance of about k pairs.
Scene with_pairs(Scene scene, double k)
{
  const auto points = make_points<Kernel, 3>(scene);
  double low = 0, high = 0.1;
  for(int step = 0; step < 20; ++step) {
    scene.r = (low + high) / 2;
    double count = 0;
    CGAL::fixed_radius_near_neighbors(points, CGAL::within_distance(scene.r),
                                      [&](std::size_t, std::size_t) { return ++count <= k; });
    (count < k ? low : high) = scene.r;
  }
  return scene;
}

void print_row(const Scene& scene, const char* order, CGAL::Point_distribution distribution)
{
  const Scene share = share_of(scene);
  const auto points = make_points<Kernel, 3>(share);
  Tally ours, theirs;
  const std::vector<Seconds> times
    = time_in_turns({timed_on_all([&] {
                       ours = search_by_processes(points, scene.r, distribution);
                     }),
                     timed_on_all([&] {
                       theirs = search_distributed_tree(share, first_of(rank(), scene));
                     })},
                    5);
  ours = sum(ours);
  theirs = sum(theirs);
  if(rank() != 0)
    return;
  const auto milliseconds = [&](std::size_t job) {
    return 1000 * median(times, [&](const Seconds& s) { return s[job]; });
  };
  print_line(scene.name + ", " + order, scene.size(), ours.pairs, process_count(),
             static_cast<std::int64_t>(theirs.pairs - ours.pairs), fixed(milliseconds(0), 0),
             fixed(milliseconds(1), 0),
             fixed(median(times, [](const Seconds& s) { return s[0] / s[1]; }), 2));
}

} // namespace

void print_trees(bool is_quick)
{
  const std::size_t n = is_quick ? 10000 : 1000000;
  if(process_count() == 1) {
    std::cout << '\n';
    print_head({"scene", ">n", ">k", ">processes", ">pairs more", ">ms of ours", ">of ArborX",
                ">ours / ArborX"});
  }
  for(const double degree : {0.5, 10.})
    for(const Scene& points : {uniform(3, n, 0), clusters(3, n)}) {
      const Scene scene = with_pairs(points, degree * static_cast<double>(n));
      print_row(scene, "shuffled", CGAL::Point_distribution::BALANCED);
      if(process_count() > 1)
        print_row(in_slabs(scene), "in slabs", CGAL::Point_distribution::AS_IS);
    }
}

} // namespace thick_benchmark
