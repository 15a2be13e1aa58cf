// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "two_meshes.h"

#include "touching_generators.h"

#include <algorithm>
#include <cmath>

namespace thick_benchmark {

namespace {

Mesh_scene shifted(Mesh_scene mesh, double x, double z)
{
  for(auto& p : mesh.points) {
    p[0] += x;
    p[2] += z;
  }
  return mesh;
}

Mesh_scene flat(Mesh_scene mesh, double z)
{
  for(auto& p : mesh.points) {
    p[0] += 0.25;
    p[2] = z;
  }
  return mesh;
}

} // namespace

std::vector<Two_meshes> two_meshes(std::size_t n)
{
  const Mesh_scene terrain = terrain_mesh(n);
  double top = 0;
  for(const auto& p : terrain.points)
    top = (std::max)(top, p[2]);
  return {{"crossing", terrain, shifted(terrain, 0.25, 0.1), true},
          {"touching", terrain, flat(terrain, top), true},
          {"a bit apart", terrain, flat(terrain, std::nextafter(top, 2)), false},
          {"far apart", terrain, shifted(terrain, 0.25, 3), false}};
}

} // namespace thick_benchmark
