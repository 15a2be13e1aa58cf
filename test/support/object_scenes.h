// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of objects whose boxes are of all sizes, on a lattice.
//
// A maker of a type of objects has the `dimension` and the number of `points` that they are made
// of, and make<Kernel>(coordinates).

#ifndef THICK_INTERSECTION_TEST_SUPPORT_OBJECT_SCENES_H
#define THICK_INTERSECTION_TEST_SUPPORT_OBJECT_SCENES_H

#include "number_boxes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_support {

using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

// An object as a list of numbers.
using Numbers = std::vector<double>; // which floats hold too

struct Object_scene
{
  std::string name;
  std::vector<Numbers> objects;
};

// Makes an object of random places in the box of a corner and extents.
template <class Maker>
Numbers object_in_box(Generator& random, const std::array<std::uint64_t, 3>& corner,
                      const std::array<std::uint64_t, 3>& extents)
{
  Numbers object;
  for(int k = 0; k < Maker::points * Maker::dimension; ++k) {
    const std::size_t axis = static_cast<std::size_t>(k % Maker::dimension);
    object.push_back(static_cast<double>(corner[axis] + random() % (extents[axis] + 1)));
  }
  return object;
}

// Calls box(i, corner, extents) for n objects, and makes each in its box, if it is not degenerate.
template <class Maker, class Box>
Object_scene object_scene(const std::string& name, std::size_t n, const Box& box)
{
  Object_scene scene = {name, {}};
  Generator random(n);
  for(std::size_t i = 0; i < n; ++i) {
    std::array<std::uint64_t, 3> corner, extents;
    box(random, i, corner, extents);
    const Numbers object = object_in_box<Maker>(random, corner, extents);
    if(!Maker::template make<Rational_kernel>(object).is_degenerate())
      scene.objects.push_back(object);
  }
  return scene;
}

// Objects whose points are vertices of a coarse lattice, so that many share vertices or edges.
template <class Maker>
Object_scene mesh_scene()
{
  using Triple = std::array<std::uint64_t, 3>;
  const auto cell = [](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = random() % (Maker::dimension == 2 ? 16 : 5);
    extents.fill(1);
  };
  return object_scene<Maker>("shared vertices", 200, cell);
}

template <class Maker>
std::vector<Object_scene> object_scenes()
{
  using Triple = std::array<std::uint64_t, 3>;
  const std::uint64_t side = Maker::dimension == 2 ? 120 : 24;
  const std::size_t n = Maker::dimension == 2 ? 600 : 300;
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
  scenes.push_back(object_scene<Maker>("power law", n, power_law));
  const auto one_giant = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(5);
    if(i == 77) {
      corner.fill(0);
      extents.fill(side);
    }
  };
  scenes.push_back(object_scene<Maker>("one giant", n, one_giant));
  const auto beams = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(1);
    corner[i % Maker::dimension] = 0;
    extents[i % Maker::dimension] = side;
  };
  scenes.push_back(object_scene<Maker>("beams", 300, beams));
  const auto nested = [&](Generator&, std::size_t i, Triple& corner, Triple& extents) {
    corner.fill(i);
    extents.fill(400 - 2 * i);
  };
  scenes.push_back(object_scene<Maker>("nested", 80, nested));
  const auto touching = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    const std::uint64_t cell = random() % 4 == 0 ? 8 : 4;
    anywhere(random, corner);
    for(std::uint64_t& c : corner)
      c = c / cell * cell;
    extents.fill(cell);
  };
  scenes.push_back(object_scene<Maker>("touching cells", n, touching));
  const auto clusters = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    for(std::uint64_t& c : corner)
      c = 100000 * (i % 10) + random() % 20;
    extents.fill(i % 10 == 0 ? 1 : 3);
  };
  scenes.push_back(object_scene<Maker>("clusters", 300, clusters));
  const auto uniform = [&](Generator& random, std::size_t, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(side / 12);
  };
  scenes.push_back(object_scene<Maker>("uniform", n, uniform));
  const auto flat = [&](Generator& random, std::size_t i, Triple& corner, Triple& extents) {
    anywhere(random, corner);
    extents.fill(side / 6);
    extents[i % Maker::dimension] = 0;
  };
  scenes.push_back(object_scene<Maker>("flat", n, flat));
  scenes.push_back(mesh_scene<Maker>());
  scenes.push_back({"identical", std::vector<Numbers>(60, scenes[0].objects.front())});
  return scenes;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_OBJECT_SCENES_H
