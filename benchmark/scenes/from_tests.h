// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of the tests as scenes of the benchmarks, and back: for their generators and oracles.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_FROM_TESTS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_FROM_TESTS_H

#include "Scene.h"

#include "support/point_scene.h"

#include <cmath>

namespace thick_benchmark {

inline Scene scene_of(const std::string& name, const test_support::Points& points, double r,
                      int dimension)
{
  Scene scene{name, dimension, {}, r};
  scene.coordinates.reserve(points.size() * static_cast<std::size_t>(dimension));
  for(const test_support::Coordinates& p : points)
    scene.coordinates.insert(scene.coordinates.end(), p.begin(), p.end());
  return scene;
}

inline Scene scene_of(const test_support::Point_scene& other)
{
  const std::string& square = other.radius.square_text();
  const double r = square.empty() ? *other.radius.length() : std::sqrt(std::stod(square));
  Scene scene = scene_of(other.name, other.points, r, other.dimension);
  scene.square = square;
  return scene;
}

// ---- what the oracles take ----------------------------------------------------------------------

inline test_support::Points points_of(const Scene& scene)
{
  test_support::Points points;
  for(std::size_t i = 0; i < scene.size(); ++i)
    points.emplace_back(scene.point(i), scene.point(i) + scene.dimension);
  return points;
}

inline test_support::Radius radius_of(const Scene& scene)
{
  return scene.square.empty() ? test_support::Radius::of_length(scene.r)
                              : test_support::Radius::of_square(scene.square);
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_FROM_TESTS_H
