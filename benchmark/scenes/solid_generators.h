// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of closed triangle meshes, whose faces are turned outwards. A scene is the same in each
// run, and its meshes are in random order.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_SOLID_GENERATORS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_SOLID_GENERATORS_H

#include "Object_scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Solid_scene
{
  std::string name;
  std::vector<Mesh_scene> solids;
};

// Round parts of 200 faces at random places. Few meet: about one of ten another one.
Solid_scene machine_parts(std::size_t count);

// Integers: about so many slabs, walls, beams, columns and pipes on a grid of storeys and bays. All
// touch others along faces, or go through them.
Solid_scene building(std::size_t count);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_SOLID_GENERATORS_H
