// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of meshes and polylines on a small lattice, where most touch others. Faces are turned over
// at random, and some are degenerate or missing.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SOLID_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_SOLID_SCENES_H

#include "feature_scenes.h"
#include "solid_oracle.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

struct Solid_scene
{
  std::string name;
  Lattice_solids solids;
};

inline Lattice_mesh faces_at(const Chain& points,
                             std::initializer_list<std::array<std::size_t, 3>> triples)
{
  Lattice_mesh mesh;
  for(const auto& [p, q, r] : triples)
    mesh.push_back({points[p], points[q], points[r]});
  return mesh;
}

inline Lattice_mesh tetrahedron_mesh(const Chain& vertices)
{
  return faces_at(vertices, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

inline Lattice_mesh box_mesh(const Lattice_point& low, const Lattice_point& high)
{
  Chain corners(8);
  for(std::size_t k = 0; k < 8; ++k)
    for(std::size_t axis = 0; axis < 3; ++axis)
      corners[k][axis] = (k >> axis & 1) != 0 ? high[axis] : low[axis];
  return faces_at(corners, {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}});
}

inline Lattice_mesh cube_mesh(std::int64_t low, std::int64_t high)
{
  return box_mesh({low, low, low}, {high, high, high});
}

inline Lattice_mesh octahedron_mesh(const Lattice_point& center, std::int64_t radius)
{
  Chain tips(6, center);
  for(std::size_t axis = 0; axis < 3; ++axis) {
    tips[axis][axis] -= radius;
    tips[axis + 3][axis] += radius;
  }
  return faces_at(tips, {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                         {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}});
}

// The faces of both: what is in one of them is inside, and what is in both is not.
inline Lattice_mesh joined(Lattice_mesh a, const Lattice_mesh& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline Lattice_mesh convex_mesh(Random& random, std::int64_t side, std::int64_t extent)
{
  const Chain points = random_chain(random, 3, 4, side, extent);
  Lattice_point high = points[0];
  for(std::size_t axis = 0; axis < 3; ++axis)
    high[axis] += below(random, extent + 1);
  switch(random.below(3)) {
  case 0: return tetrahedron_mesh(points);
  case 1: return box_mesh(points[0], high);
  default: return octahedron_mesh(points[0], below(random, extent / 2 + 1));
  }
}

// Turns faces over, and adds some that are points, segments or twice there. Few meshes lose faces.
inline void roughen(Random& random, Lattice_mesh& mesh)
{
  for(Lattice_face& face : mesh)
    if(random.below(4) == 0)
      std::swap(face[0], face[1]);
  const Lattice_face face = mesh[random.below(mesh.size())];
  switch(random.below(10)) {
  case 0: mesh.push_back({face[0], face[0], face[0]}); break;
  case 1: mesh.push_back({face[0], face[1], face[0]}); break;
  case 2: mesh.insert(mesh.end(), {face, face}); break;
  case 3: mesh.erase(mesh.begin() + static_cast<std::ptrdiff_t>(random.below(mesh.size()))); break;
  case 4: mesh.resize(mesh.size() - 2);
  }
}

inline Lattice_solid random_solid(Random& random, std::int64_t side, std::int64_t extent)
{
  const auto convex = [&] { return convex_mesh(random, side, extent); };
  const auto chain = [&](std::size_t size) { return random_chain(random, 3, size, side, extent); };
  Lattice_solid solid;
  switch(random.below(10)) {
  case 0: solid.meshes = {joined(joined(convex(), convex()), convex())}; break;
  case 1: solid.meshes = {joined(convex(), convex())}; break;
  case 2: solid.meshes = {convex(), convex()}; break;
  case 3: solid.chains = {chain(1 + random.below(3))}; break;
  case 4:
    solid.meshes = {convex()};
    solid.chains = {chain(random.below(3))};
    break;
  case 5: {
    const Chain points = chain(6);
    solid.meshes = {faces_at(points, {{0, 1, 2}, {1, 2, 3}, {3, 4, 5}})};
    break;
  }
  default: solid.meshes = {convex()};
  }
  for(Lattice_mesh& mesh : solid.meshes)
    roughen(random, mesh);
  return solid;
}

// A mesh whose tree is sorted.
inline Lattice_solid random_solid_of_many_faces(std::uint64_t seed)
{
  Random random(seed);
  Lattice_mesh mesh;
  while(mesh.size() < 300)
    mesh = joined(mesh, convex_mesh(random, 12, 6));
  return {{mesh}, {}};
}

// A large solid that does not fill its box, and unions of small ones, some of which are inside it.
inline Solid_scene random_scene_of_parts(std::uint64_t seed)
{
  Solid_scene scene = {"parts " + std::to_string(seed), {}};
  Random random(seed);
  const Lattice_mesh octahedron = octahedron_mesh({14, 14, 14}, 13);
  scene.solids.push_back(
    {{seed % 2 == 0 ? octahedron : joined(cube_mesh(0, 28), octahedron)}, {}});
  for(int i = 0; i < 10; ++i) {
    Lattice_solid parts;
    for(int k = 0; k < 5; ++k)
      parts.meshes.push_back(convex_mesh(random, 25, 2));
    scene.solids.push_back(parts);
  }
  return scene;
}

inline Solid_scene random_solid_scene(std::uint64_t seed, std::size_t size, std::int64_t side,
                                      std::int64_t extent)
{
  Solid_scene scene = {"random " + std::to_string(seed), {}};
  Random random(seed);
  for(std::size_t i = 0; i < size; ++i)
    scene.solids.push_back(random_solid(random, side, extent));
  return scene;
}

// Shells, each in the hollow of the one before it, with small things in and between them. Some
// hollows touch the outside, or the shell in them.
inline Solid_scene onion_scene()
{
  Solid_scene scene = {"onion", {}};
  Random random(1);
  for(std::int64_t i = 0; i < 8; ++i) {
    const std::int64_t low = 3 * i, high = 60 - 3 * i;
    const Lattice_mesh hollow = i % 3 == 0   ? cube_mesh(low + 2, high - 2)
                                : i % 3 == 1 ? cube_mesh(low + 3, high - 3)
                                             : octahedron_mesh({30, 30, 30}, 30 - low);
    scene.solids.push_back({{joined(cube_mesh(low, high), hollow)}, {}});
  }
  for(int i = 0; i < 40; ++i)
    scene.solids.push_back(random_solid(random, 60, 3));
  return scene;
}

// A comb whose teeth are above each other, and a staircase that winds around an axis, with small
// things in and between. The faces of each are so many that their tree is sorted.
inline Solid_scene overhang_scene()
{
  Solid_scene scene = {"overhangs", {}};
  Random random(2);
  Lattice_mesh comb = box_mesh({0, 0, 0}, {2, 9, 75}), stairs;
  for(std::int64_t i = 0; i < 25; ++i) {
    comb = joined(comb, box_mesh({2, 0, 3 * i}, {20, 9, 3 * i + 1}));
    const std::int64_t x = i % 4 == 1 || i % 4 == 2 ? 10 : 0, y = i % 4 < 2 ? 0 : 10;
    stairs = joined(stairs, box_mesh({30 + x, y, 3 * i}, {40 + x, 10 + y, 3 * i + 4}));
  }
  scene.solids = {{{comb}, {}}, {{stairs}, {}}};
  for(int i = 0; i < 60; ++i)
    scene.solids.push_back(random_solid(random, 50, 3));
  return scene;
}

inline std::vector<Solid_scene> small_solid_scenes(std::uint64_t count)
{
  std::vector<Solid_scene> scenes;
  for(std::uint64_t seed = 0; seed < count; ++seed) {
    scenes.push_back(random_solid_scene(2 * seed, 12, 4, 4));
    scenes.push_back(random_solid_scene(2 * seed + 1, 20, 12, 8));
  }
  return scenes;
}

inline std::vector<Solid_scene> solid_scenes(std::uint64_t count)
{
  std::vector<Solid_scene> scenes = small_solid_scenes(count);
  scenes.push_back(onion_scene());
  scenes.push_back(overhang_scene());
  return scenes;
}

// Meshes alone, of which features without any have one face.
inline Solid_scene without_chains(Solid_scene scene)
{
  for(Lattice_solid& solid : scene.solids) {
    if(solid.meshes.empty())
      solid.meshes = {{{solid.chains[0].front(), solid.chains[0].back(), solid.chains[0][0]}}};
    solid.chains.clear();
  }
  return scene;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SOLID_SCENES_H
