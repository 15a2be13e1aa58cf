// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/Factors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace thick_benchmark {
namespace {

Subject_search search_of(const Recipe& recipe)
{
  for(const auto& some : {near_searches(), box_searches(), closest_searches()})
    for(const Subject_search& search : some)
      if(search.name == recipe.search)
        return search;
  throw std::invalid_argument("There is no search " + recipe.search);
}

// Longer searches are measured once.
Work least_of(const Subject_search& search, const Made_scene& scene, int rounds)
{
  const double long_seconds = 0.1;
  Work work = search.run(scene);
  for(int round = 1; round < rounds && work.seconds < long_seconds; ++round)
    work.seconds = (std::min)(work.seconds, search.run(scene).seconds);
  return work;
}

} // namespace

std::optional<Factor> Factors::of(const Recipe& recipe)
{
  const Subject_search search = search_of(recipe);
  const Work work = least_of(search, make_scene(recipe, search.dimension), 5);
  if(!std::isfinite(work.pairs))
    return std::nullopt;
  const double n = static_cast<double>(recipe.n);
  const Work usual = uniform(recipe, work.pairs / n);
  const double share = (n + usual.pairs) / (n + work.pairs);
  return Factor{work.pairs / n, usual.counted == 0 ? 0 : work.counted / usual.counted * share,
                work.seconds / usual.seconds * share};
}

// Pairs per element are rounded to a power of two, and to 2^-4 if they are fewer.
Work Factors::uniform(const Recipe& recipe, double pairs_per_element)
{
  const Subject_search search = search_of(recipe);
  const double n = static_cast<double>(recipe.n);
  const double rounded
    = std::exp2(std::round(std::log2((std::max)(pairs_per_element, 1. / 16))));
  const auto [known, is_new] = uniform_.insert({{recipe.search, recipe.n, rounded}, {}});
  if(is_new) {
    Recipe usual;
    usual.search = recipe.search;
    usual.n = recipe.n;
    usual.reach.factor
      = search.reach_of_pairs == 0
          ? 0.01 * std::pow(n, -2. / search.dimension)
          : std::pow(2 * rounded / n / search.reach_of_pairs, 1. / search.dimension);
    known->second = least_of(search, make_scene(usual, search.dimension), 9);
  }
  return known->second;
}

} // namespace thick_benchmark
