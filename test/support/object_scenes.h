// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of objects on a lattice, whose boxes are of all sizes. Some objects are degenerate.
//
// A maker of a type of objects has the `dimension` and the number of `points` that they are made
// of, make<Kernel>(coordinates), and whether they `are_boxes`.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_OBJECT_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_OBJECT_SCENES_H

#include "number_boxes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace test_support {

// An object as a list of numbers.
using Numbers = std::vector<double>; // which floats hold too

struct Object_scene
{
  std::string name;
  std::vector<Numbers> objects;
};

// A type of objects, as the scenes see it: one function makes those of all types.
struct Object_kind
{
  int dimension;
  int points;
};

template <class Maker>
Object_kind object_kind()
{
  return {Maker::dimension, Maker::points};
}

// Along each axis, a coordinate of a corner of a box, or an extent of it.
using Triple = std::array<std::uint64_t, 3>;

// Makes an object of random places in the box of a corner and extents.
inline Numbers object_in_box(const Object_kind& kind, Generator& random, const Triple& corner,
                             const Triple& extents)
{
  Numbers object;
  for(int k = 0; k < kind.points * kind.dimension; ++k) {
    const std::size_t axis = static_cast<std::size_t>(k % kind.dimension);
    object.push_back(static_cast<double>(corner[axis] + random() % (extents[axis] + 1)));
  }
  return object;
}

// Calls box(random, i, corner, extents) for n objects, and makes each in its box.
using Box_maker = std::function<void(Generator&, std::size_t, Triple&, Triple&)>;
inline Object_scene object_scene(const Object_kind& kind, const std::string& name, std::size_t n,
                                 const Box_maker& box)
{
  Object_scene scene = {name, {}};
  Generator random(n);
  for(std::size_t i = 0; i < n; ++i) {
    Triple corner, extents;
    box(random, i, corner, extents);
    scene.objects.push_back(object_in_box(kind, random, corner, extents));
  }
  return scene;
}

// Objects of one size on a lattice of a unit, rounded as kernels of floats need it.
inline Object_scene scene_of_unit(const Object_kind& kind, float unit)
{
  const std::string name = "unit " + std::to_string(unit);
  const std::uint64_t side = kind.dimension == 2 ? 40 : 12;
  Object_scene scene
    = object_scene(kind, name, 250, [=](Generator& random, std::size_t, Triple& c, Triple& e) {
        for(std::uint64_t& corner : c)
          corner = random() % side;
        e.fill(5);
      });
  for(Numbers& object : scene.objects)
    for(double& x : object)
      x = unit * static_cast<float>(x);
  return scene;
}

// Objects whose points are vertices of a coarse lattice, so that many share vertices or edges. Of
// boxes these are cells, and faces, edges and vertices of cells.
inline Object_scene mesh_scene(const Object_kind& kind)
{
  const std::uint64_t side = kind.dimension == 2 ? 16 : 5;
  const auto cell = [=](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = random() % side;
    extents.fill(1);
  };
  return object_scene(kind, "shared vertices", 200, cell);
}

// Objects of several sizes that touch others along faces, also those that are flat, thin or points.
inline Object_scene face_scene(const Object_kind& kind)
{
  const std::uint64_t side = kind.dimension == 2 ? 40 : 10;
  const auto face = [=](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = 2 * (random() % side);
    for(std::size_t axis = 0; axis < extents.size(); ++axis)
      extents[axis] = random() % 3 == 0 ? 0 : i % 16 == 0 ? 6 : 2;
  };
  return object_scene(kind, "faces", kind.dimension == 2 ? 600 : 250, face);
}

inline std::vector<Object_scene> object_scenes(const Object_kind& kind)
{
  const std::size_t dimension = static_cast<std::size_t>(kind.dimension);
  const std::uint64_t side = dimension == 2 ? 120 : 24;
  const std::size_t n = dimension == 2 ? 600 : 300;
  const auto anywhere = [=](Generator& random, Triple& corner) {
    for(std::uint64_t& c : corner)
      c = random() % side;
  };
  std::vector<Object_scene> scenes;
  const auto power_law = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    const double u = static_cast<double>(1 + random() % 1000) / 1000;
    for(std::uint64_t& e : extents)
      e = 1 + (std::min)(side, static_cast<std::uint64_t>(3 / u)) / (1 + random() % 2);
  };
  scenes.push_back(object_scene(kind, "power law", n, power_law));
  const auto one_giant = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(5);
    if(i == 77) {
      corner.fill(0);
      extents.fill(side);
    }
  };
  scenes.push_back(object_scene(kind, "one giant", n, one_giant));
  const auto beams = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(1);
    corner[i % dimension] = 0;
    extents[i % dimension] = side;
  };
  scenes.push_back(object_scene(kind, "beams", 300, beams));
  const auto nested = [&](Generator&, std::size_t i, Triple& corner, Triple& extents) {
    corner.fill(i);
    extents.fill(400 - 2 * i);
  };
  scenes.push_back(object_scene(kind, "nested", 80, nested));
  const auto touching = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    const std::uint64_t cell = random() % 4 == 0 ? 8 : 4;
    anywhere(random, corner);
    for(std::uint64_t& c : corner)
      c = c / cell * cell;
    extents.fill(cell);
  };
  scenes.push_back(object_scene(kind, "touching cells", n, touching));
  const auto clusters = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = 100000 * (i % 10) + random() % 20;
    extents.fill(i % 10 == 0 ? 1 : 3);
  };
  scenes.push_back(object_scene(kind, "clusters", 300, clusters));
  const auto uniform = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(side / 12);
  };
  scenes.push_back(object_scene(kind, "uniform", n, uniform));
  const auto flat = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(side / 6);
    extents[i % dimension] = 0;
  };
  scenes.push_back(object_scene(kind, "flat", n, flat));
  const auto tiny = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = random() % 3;
    extents.fill(1 + random() % 2); // most objects are degenerate
  };
  scenes.push_back(object_scene(kind, "tiny", 150, tiny));
  scenes.push_back(mesh_scene(kind));
  scenes.push_back(face_scene(kind));
  scenes.push_back({"identical", std::vector<Numbers>(60, scenes[0].objects.front())});
  for(const float unit : {1.f, 0.1f})
    scenes.push_back(scene_of_unit(kind, unit));
  return scenes;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_OBJECT_SCENES_H
