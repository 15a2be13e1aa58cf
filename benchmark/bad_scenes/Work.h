// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The work of a search, and the searches.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_WORK_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_WORK_H

#include "bad_scenes/Made_scene.h"

#include <string>
#include <vector>

namespace thick_benchmark {

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
  bool has_extents; // the objects are boxes
  Work (*run)(const Made_scene& scene);
  double reach_of_pairs; // uniform points have (reach_of_pairs reach^dimension n^2 / 2) pairs
};

std::vector<Subject_search> near_searches();
std::vector<Subject_search> box_searches();
std::vector<Subject_search> closest_searches();

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_WORK_H
