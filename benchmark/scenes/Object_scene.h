// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of objects with an extent, in one set or in two.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_OBJECT_SCENE_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_OBJECT_SCENE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace thick_benchmark {

// What the numbers of an object are: the lower and the upper corner, the center and the radius, the
// two ends, the three corners, the four corners.
enum class Shape { BOX, BALL, SEGMENT, TRIANGLE, TETRAHEDRON };

// Of objects other than balls.
inline std::size_t corners_of(Shape shape)
{
  return shape == Shape::TETRAHEDRON ? 4 : shape == Shape::TRIANGLE ? 3 : 2;
}

struct Object_scene
{
  std::string name;
  Shape shape;
  int dimension;
  std::vector<double> numbers; // object by object
  std::size_t size_a = 0;      // objects of the first set, which come first; 0: there is one set

  std::size_t numbers_per_object() const
  {
    const auto d = static_cast<std::size_t>(dimension);
    return shape == Shape::BALL ? d + 1 : corners_of(shape) * d;
  }
  std::size_t size() const { return numbers.size() / numbers_per_object(); }
  const double* object(std::size_t i) const { return numbers.data() + i * numbers_per_object(); }
};

// Segments or triangles in one set, and the distance within which they are near.
struct Near_scene
{
  std::string name;
  Object_scene objects;
  double r;
};

// A triangle mesh.
struct Mesh_scene
{
  std::string name;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> faces; // counterclockwise from one side
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_OBJECT_SCENE_H
