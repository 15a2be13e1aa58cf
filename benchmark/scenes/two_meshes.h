// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Two meshes of about n faces each, and whether they meet.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_TWO_MESHES_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_TWO_MESHES_H

#include "Mesh_scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Two_meshes
{
  std::string name;
  Mesh_scene a, b;
  bool do_meet;
};

// A terrain, and the same terrain shifted, so that they cross or are far apart; or a flat mesh that
// touches the highest vertex of the terrain, or is a last bit above it.
std::vector<Two_meshes> two_meshes(std::size_t n);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_TWO_MESHES_H
