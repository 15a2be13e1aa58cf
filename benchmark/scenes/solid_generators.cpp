// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "solid_generators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace thick_benchmark {

namespace {

using Point = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;

// A sphere with bumps: ten meridians, of ten vertices each between the poles.
Mesh_scene machine_part(std::mt19937_64& random, double radius)
{
  constexpr std::uint32_t around = 10, along = 10;
  std::uniform_real_distribution<double> place(0, 1), bump(.8, 1.2);
  const Point center = {place(random), place(random), place(random)};
  Mesh_scene part;
  const auto add = [&](double latitude, double longitude) {
    const double r = radius * bump(random);
    part.points.push_back({center[0] + r * std::sin(latitude) * std::cos(longitude),
                           center[1] + r * std::sin(latitude) * std::sin(longitude),
                           center[2] + r * std::cos(latitude)});
  };
  add(0, 0);
  for(std::uint32_t i = 0; i < along; ++i)
    for(std::uint32_t j = 0; j < around; ++j)
      add(pi * (i + 1) / (along + 1), 2 * pi * j / around);
  add(pi, 0);
  const auto at = [](std::uint32_t i, std::uint32_t j) { return 1 + i * around + j % around; };
  const std::uint32_t last = along * around + 1;
  for(std::uint32_t j = 0; j < around; ++j) {
    part.faces.push_back({0, at(0, j), at(0, j + 1)});
    part.faces.push_back({last, at(along - 1, j + 1), at(along - 1, j)});
    for(std::uint32_t i = 0; i + 1 < along; ++i) {
      part.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      part.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return part;
}

// A prism between two heights over a polygon that turns left.
Mesh_scene prism(const std::vector<std::array<double, 2>>& polygon, double bottom, double top)
{
  Mesh_scene prism;
  const auto size = static_cast<std::uint32_t>(polygon.size());
  for(const double z : {bottom, top})
    for(const auto& [x, y] : polygon)
      prism.points.push_back({x, y, z});
  for(std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t next = (i + 1) % size;
    prism.faces.push_back({i, next, size + next});
    prism.faces.push_back({i, size + next, size + i});
    if(i > 1) {
      prism.faces.push_back({0, i, i - 1});
      prism.faces.push_back({size, size + i - 1, size + i});
    }
  }
  return prism;
}

Mesh_scene block(const Point& low, const Point& high)
{
  return prism({{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}},
               low[2], high[2]);
}

// Twelve sides, with integers as coordinates.
Mesh_scene pipe(double x, double y, double bottom, double top)
{
  std::vector<std::array<double, 2>> ring;
  for(int k = 0; k < 12; ++k)
    ring.push_back({x + std::round(40 * std::cos(pi * k / 6)),
                    y + std::round(40 * std::sin(pi * k / 6))});
  return prism(ring, bottom, top);
}

// In millimeters: the bay [0, 4000]^2 of a storey from z to z + 3000.
void add_bay(std::vector<Mesh_scene>& solids, double x, double y, double z)
{
  solids.push_back(block({x, y, z - 200}, {x + 4000, y + 4000, z}));                     // slab
  solids.push_back(block({x, y, z}, {x + 300, y + 300, z + 2800}));                      // column
  solids.push_back(block({x + 300, y, z + 2500}, {x + 4000, y + 300, z + 2800}));        // beams
  solids.push_back(block({x, y + 300, z + 2500}, {x + 300, y + 4000, z + 2800}));
  solids.push_back(block({x + 300, y + 100, z}, {x + 4000, y + 200, z + 2500}));         // walls
  solids.push_back(block({x + 100, y + 300, z}, {x + 200, y + 4000, z + 2500}));
  solids.push_back(pipe(x + 1000, y + 1000, z - 200, z + 2800));                         // pipe
}

} // namespace

Solid_scene machine_parts(std::size_t count)
{
  Solid_scene scene = {"parts of 200 faces", {}};
  std::mt19937_64 random(1);
  // Parts meet if their centers are closer than twice the radius, which .1 of them are to another.
  const double radius = std::cbrt(.1 / (4 * pi / 3 * 8 * static_cast<double>(count)));
  for(std::size_t i = 0; i < count; ++i)
    scene.solids.push_back(machine_part(random, radius));
  return scene;
}

Solid_scene building(std::size_t count)
{
  Solid_scene scene = {"building", {}};
  const auto side = static_cast<int>(std::cbrt(static_cast<double>(count) / 7) + .5);
  for(int i = 0; i < side; ++i)
    for(int j = 0; j < side; ++j)
      for(int k = 0; k < side; ++k)
        add_bay(scene.solids, 4000. * i, 4000. * j, 3000. * k);
  std::shuffle(scene.solids.begin(), scene.solids.end(), std::mt19937_64(1));
  return scene;
}

} // namespace thick_benchmark
