// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The scene of a recipe, the searches that are made of it, and their work.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_WORK_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_WORK_H

#include "bad_scenes/Recipe.h"

#include <CGAL/Dimension.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace thick_benchmark {

// Coordinates along up to five axes.
struct Made_box
{
  std::array<double, 5> low = {};
  std::array<double, 5> extent = {};
};

// Boxes, of which a search for points takes the lower corners.
struct Made_scene
{
  int dimension = 0;
  std::vector<Made_box> boxes;
  double reach = 0;
  std::size_t first_size = 0; // of the first of two sets
};

// Makes the scene of a recipe, in some dimension.
Made_scene make_scene(const Recipe& recipe, int dimension);

template <class Point>
std::vector<Point> points_of(const Made_scene& scene)
{
  std::vector<Point> points;
  for(const Made_box& box : scene.boxes)
    if constexpr(CGAL::Ambient_dimension<Point>::value == 2)
      points.emplace_back(box.low[0], box.low[1]);
    else if constexpr(CGAL::Ambient_dimension<Point>::value == 3)
      points.emplace_back(box.low[0], box.low[1], box.low[2]);
    else
      points.emplace_back(box.low);
  return points;
}

struct Work
{
  double pairs = 0;   // of the union of two sets; infinite if there are too many to be counted
  double counted = 0; // candidates looked at, and elements moved or swept; 0 if not counted
  double seconds = 0; // of the processor
};

// So many pairs per element are counted.
inline constexpr double max_pairs_per_element = 45;

struct Subject_search
{
  std::string name;
  int dimension;
  Work (*run)(const Made_scene& scene);
  double reach_of_pairs; // uniform points have (reach_of_pairs reach^dimension n^2 / 2) pairs
};

std::vector<Subject_search> near_searches();
std::vector<Subject_search> box_searches();
std::vector<Subject_search> closest_searches();

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_WORK_H
