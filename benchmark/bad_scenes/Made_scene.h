// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The scene of a recipe: boxes, of which a search for points takes the lower corners.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_MADE_SCENE_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_MADE_SCENE_H

#include "bad_scenes/Recipe.h"

#include <array>
#include <cstddef>
#include <vector>

namespace thick_benchmark {

inline constexpr int max_scene_dimension = 5;

struct Made_box
{
  std::array<double, max_scene_dimension> low = {};
  std::array<double, max_scene_dimension> extent = {};
};

struct Made_scene
{
  int dimension = 0;
  std::vector<Made_box> boxes;
  double reach = 0;
  std::size_t first_size = 0; // of the first of two sets
};

// Makes the scene of a recipe, in some dimension.
Made_scene make_scene(const Recipe& recipe, int dimension);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_MADE_SCENE_H
