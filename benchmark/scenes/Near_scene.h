// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments or triangles in one set, and the distance within which they are near.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_NEAR_SCENE_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_NEAR_SCENE_H

#include "Object_scene.h"

#include <string>

namespace thick_benchmark {

struct Near_scene
{
  std::string name;
  Object_scene objects;
  double r;
};

// Segments or triangles whose corners are on a lattice, at most two steps apart along each axis.
// About half of the places of the lattice are the first corner of an object, and objects within one
// step are near: many are at exactly this distance. Coordinates are multiples of the step, each
// rounded to a double. No object is degenerate.
Near_scene lattice_scene(Shape shape, int dimension, std::size_t n, double step);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_NEAR_SCENE_H
