// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_tables.h"

#include "measuring/timing.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>

#include <random>

namespace thick_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Segments between random points of the unit cube, and triangles at random places in it.
struct Rays
{
  std::vector<Kernel::Segment_3> rays;
  std::vector<Kernel::Triangle_3> triangles;
};

Rays random_rays(std::size_t ray_count, std::size_t triangle_count)
{
  constexpr double size = 0.003;
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto point = [&](const Kernel::Point_3& from, double side) {
    const double x = uniform(engine), y = uniform(engine);
    return from + side * Kernel::Vector_3(x, y, uniform(engine));
  };
  Rays scene;
  for(std::size_t i = 0; i < ray_count; ++i) {
    const Kernel::Point_3 source = point(CGAL::ORIGIN, 1);
    scene.rays.emplace_back(source, point(CGAL::ORIGIN, 1));
  }
  for(std::size_t i = 0; i < triangle_count; ++i) {
    const Kernel::Point_3 corner = point(CGAL::ORIGIN, 1), second = point(corner, size);
    scene.triangles.emplace_back(corner, second, point(corner, size));
  }
  return scene;
}

std::size_t count_by_tree(const Rays& scene)
{
  using Primitive
    = CGAL::AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::const_iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(scene.triangles.begin(),
                                                                   scene.triangles.end());
  std::size_t count = 0;
  for(const Kernel::Segment_3& ray : scene.rays)
    count += tree.number_of_intersected_primitives(ray);
  return count;
}

std::size_t count_by_ours(const Rays& scene)
{
  std::size_t count = 0;
  CGAL::thick_intersection_d(scene.rays, scene.triangles,
                             [&](std::size_t, std::size_t) { ++count; });
  return count;
}

void print_times(const Rays& scene, int rounds)
{
  constexpr double target = 1. / 3; // ours is to take at most three times as long as the tree
  const std::string name = std::to_string(scene.rays.size()) + " rays, "
                           + std::to_string(scene.triangles.size()) + " triangles";
  std::vector<std::size_t> counts;
  const auto counted = [&](const auto& count) {
    counts.push_back(count(scene));
    return timed([&scene, count] { return count(scene); });
  };
  const std::vector<Job> jobs = {counted(count_by_ours), counted(count_by_tree)};
  const std::vector<Seconds> times = time_in_turns(jobs, rounds, 0);
  const double ratio = median(times, [](const Seconds& s) { return s[1] / s[0]; });
  print_line(name, "thick_intersection_d", counts[0],
             1000 * median(times, [](const Seconds& s) { return s[0]; }), 1, "", "");
  print_line(name, "AABB_tree", counts[1],
             1000 * median(times, [](const Seconds& s) { return s[1]; }), ratio, ">= 0.333",
             ratio >= target ? "met" : "missed");
}

} // namespace

void print_rays(std::size_t n, int rounds)
{
  std::cout << "\nLong rays among small triangles.\n\n";
  print_head("rays", "found", "ms", "time / ours", "target", "verdict");
  print_times(random_rays(n / 100, n / 10), rounds);
  print_times(random_rays(n / 10, n), rounds);
}

} // namespace thick_benchmark
