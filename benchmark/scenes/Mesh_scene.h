// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A scene that is a triangle mesh.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_MESH_SCENE_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_MESH_SCENE_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Mesh_scene
{
  std::string name;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> faces; // counterclockwise from one side
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_MESH_SCENE_H
