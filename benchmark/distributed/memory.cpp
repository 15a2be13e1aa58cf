// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The peak of memory of a process, as Linux tells it, for each of its points.

#include "Processes.h"

#include "table/print.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/distributed_fixed_radius_near_neighbors.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace thick_benchmark {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Returns an entry of the status of this process, in bytes.
double status_entry(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(double kilobytes; word == name && status >> kilobytes)
      return 1024 * kilobytes;
  return 0;
}

void search(const std::vector<Kernel::Point_3>& points, double r)
{
  CGAL::distributed_fixed_radius_near_neighbors(MPI_COMM_WORLD, points, CGAL::within_distance(r),
                                                [](std::uint64_t, std::uint64_t) {});
}

// These are made where they are to be, so that no memory is left over from making them.
std::vector<Kernel::Point_3> uniform_points(std::size_t n)
{
  std::mt19937_64 random(static_cast<std::uint64_t>(rank()));
  std::uniform_real_distribution<double> coordinate;
  std::vector<Kernel::Point_3> points;
  points.reserve(n);
  while(points.size() < n) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

} // namespace

// MPI and an empty search have had their memory before. There are about 4 pairs for each point.
void print_memory(bool is_quick)
{
  const std::size_t n = is_quick ? 10000 : 500000;
  if(process_count() == 1) {
    std::cout << '\n';
    print_head({">processes", ">points on each", ">bytes / point, the points", ">the peak"});
  }
  const double pi = std::acos(-1.);
  const double r = std::cbrt(6 / (pi * static_cast<double>(n) * process_count()));
  search({}, r);
  const double before = status_entry("VmRSS:");
  const auto per_point = [&](const std::string& entry) {
    return maximum((status_entry(entry) - before) / static_cast<double>(n));
  };
  const std::vector<Kernel::Point_3> points = uniform_points(n);
  const double of_points = per_point("VmRSS:");
  search(points, r);
  const double peak = per_point("VmHWM:");
  if(rank() == 0)
    print_line(process_count(), n, fixed(of_points, 1), fixed(peak, 1));
}

} // namespace thick_benchmark
