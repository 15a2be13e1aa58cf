// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a scene is made by: uniform points in the unit cube, and changes of some of them, one after
// the other. A recipe is a line of text:
//
//   near3 seed=1 r=1/n first=0.5 place:0:0.3:1e-9@all:1 place:2:0.7:1e-9@all:1
//
// is searched by near3, within 1/n; `first` is the share of the first of two sets. A change is
//
//   <kind>:<axis>:<a>:<b>@<where>:<share>
//
// where all axes are changed if <axis> is the dimension. make_scene.cpp tells the kinds, and where
// they apply.

#ifndef THICK_INTERSECTION_BENCHMARK_BAD_SCENES_RECIPE_H
#define THICK_INTERSECTION_BENCHMARK_BAD_SCENES_RECIPE_H

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace thick_benchmark {

// A number of a recipe: plain, in reaches, or over a power of n: "0.3", "4.5r", "600/n" or
// "1/n^0.5". So a recipe serves any n.
struct Amount
{
  double factor = 0;
  bool is_in_reaches = false;
  double exponent = 0;

  double at(double n, double reach) const
  {
    return factor * (is_in_reaches ? reach : 1) * std::pow(n, -exponent);
  }
};

struct Change
{
  std::string kind;
  int axis = 0;
  Amount a, b;
  std::string where;
  double share = 1;
};

struct Recipe
{
  std::string search;
  std::size_t n = 0;
  unsigned int seed = 1;
  Amount reach;
  double first_share = 0.5;
  std::vector<Change> changes;
};

Recipe read_recipe(const std::string& line);

// The scenes that were bad once, without n.
std::vector<const char*> known_recipes();

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_BAD_SCENES_RECIPE_H
