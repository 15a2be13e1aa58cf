// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// How bad a scene is: its work per element and pair, over that of uniform points with as many
// elements and about as many pairs. Of two sets of uniform points, each is one half.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_FACTORS_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_FACTORS_H

#include "bad_scenes/Work.h"

#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace thick_benchmark {

struct Factor
{
  double pairs; // per element
  double counted; // 0 if it is not counted
  double time;
};

class Factors
{
public:
  // Times are the least of some rounds. Returns nothing if there are too many pairs to be counted.
  std::optional<Factor> of(const Recipe& recipe);

private:
  Work uniform(const Recipe& recipe, double pairs_per_element);

  std::map<std::tuple<std::string, std::size_t, double>, Work> uniform_; // by search, n, and pairs
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_FACTORS_H
