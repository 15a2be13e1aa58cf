// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_methods.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/thick_intersection_d.h>

#include <memory>
#include <random>
#include <vector>

namespace thick_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;

// Segments between random points of the unit cube, and triangles at random places in it.
struct Rays
{
  std::vector<Kernel::Segment_3> rays;
  Triangles triangles;
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
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
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

} // namespace

std::vector<Counted> ways_of_rays(std::size_t ray_count, std::size_t triangle_count)
{
  const auto scene = std::make_shared<const Rays>(random_rays(ray_count, triangle_count));
  return {{"thick_intersection_d", [=] { return count_by_ours(*scene); }},
          {"AABB_tree", [=] { return count_by_tree(*scene); }}};
}

} // namespace thick_benchmark
