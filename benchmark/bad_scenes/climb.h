// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for bad scenes: climbing from known recipes, from good finds and from nothing, until
// the time is over.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_CLIMB_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_CLIMB_H

#include "bad_scenes/Factors.h"
#include "bad_scenes/Recipe.h"

#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Find
{
  Recipe recipe;
  Factor factor;        // at n
  Factor larger_factor; // at 4 n

  // The factor at 16 n, if it goes on to grow as it does from n to 4 n.
  double score() const;
};

struct Climb_options
{
  std::string search;
  std::size_t n = 4000;
  double seconds = 60;
  double noteworthy = 8; // finds with a larger score are shown
};

class Climb
{
public:
  using Show = std::function<void(const Find&)>;

  Climb(const Climb_options& options, unsigned int seed, const Show& show);

  // Starts from these recipes first, then at random. Returns the best find.
  Find run(const std::vector<Recipe>& known);

  std::size_t count() const { return count_; } // of the recipes looked at

private:
  Find look_at(const Recipe& recipe, double least_factor, int rounds);
  Find climb(Find find, double end);
  Find shorten(Find find);
  void keep(const Find& find);
  Recipe start(const std::vector<Recipe>& known, std::size_t number);

  const Climb_options options_;
  const Show show_;
  std::mt19937_64 random_;
  Factors factors_;
  std::vector<Find> finds_; // the best of each climb
  std::size_t count_ = 0;
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_CLIMB_H
