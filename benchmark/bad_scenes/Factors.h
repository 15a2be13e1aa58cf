// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How bad a scene is: its work per element and pair, over that of uniform points with as many
// elements and about as many pairs. Of two sets of uniform points, each is one half.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_FACTORS_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_FACTORS_H

#include "bad_scenes/Recipe.h"
#include "bad_scenes/Work.h"

#include <map>
#include <string>

namespace thick_benchmark {

struct Factor
{
  double pairs = 0; // per element
  double counted = 0;
  double time = 0;

  double larger() const { return counted > time ? counted : time; }
};

const std::vector<Subject_search>& all_searches();
const Subject_search& search_of(const Recipe& recipe);

class Factors
{
public:
  // Returns zeros if the scene cannot be measured: coordinates overflow, or there are too many
  // pairs. Times are the least of some rounds.
  Factor of(const Recipe& recipe, int rounds);

private:
  Work uniform(const Recipe& recipe, double pairs_per_element);

  std::map<std::string, Work> uniform_; // by the line of its recipe
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_FACTORS_H
