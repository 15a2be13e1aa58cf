// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/Factors.h"

#include <algorithm>
#include <cmath>

namespace thick_benchmark {
namespace {

// Longer searches are measured once.
const double long_seconds = 0.1;

Work least_of(const Subject_search& search, const Made_scene& scene, int rounds)
{
  Work work = search.run(scene);
  for(int round = 1; round < rounds && work.seconds < long_seconds; ++round) {
    if(!std::isfinite(work.pairs))
      break;
    work.seconds = (std::min)(work.seconds, search.run(scene).seconds);
  }
  return work;
}

bool is_measurable(const Made_scene& scene)
{
  const auto is_good = [](double x) { return std::fabs(x) <= 1e300; };
  for(const Made_box& box : scene.boxes)
    if(!std::all_of(box.low.begin(), box.low.end(), is_good)
       || !std::all_of(box.extent.begin(), box.extent.end(), is_good))
      return false;
  return scene.reach >= 0 && is_good(scene.reach) && scene.first_size <= scene.boxes.size();
}

} // namespace

const std::vector<Subject_search>& all_searches()
{
  static const std::vector<Subject_search> searches = [] {
    std::vector<Subject_search> all;
    for(const auto& some : {near_searches(), box_searches(), closest_searches()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return searches;
}

const Subject_search& search_of(const Recipe& recipe)
{
  for(const Subject_search& search : all_searches())
    if(search.name == recipe.search)
      return search;
  throw std::invalid_argument("There is no search " + recipe.search);
}

Factor Factors::of(const Recipe& recipe, int rounds)
{
  const Subject_search& search = search_of(recipe);
  const Made_scene scene = make_scene(recipe, search.dimension);
  if(!is_measurable(scene))
    return {};
  const Work work = least_of(search, scene, rounds);
  if(!std::isfinite(work.pairs))
    return {};
  const double n = static_cast<double>(recipe.n);
  const Work usual = uniform(recipe, work.pairs / n);
  const double share = (n + usual.pairs) / (n + work.pairs);
  return {work.pairs / n, work.counted / usual.counted * share,
          work.seconds / usual.seconds * share};
}

// Pairs per element are rounded to a power of two, and to 2^-4 if they are fewer.
Work Factors::uniform(const Recipe& recipe, double pairs_per_element)
{
  const Subject_search& search = search_of(recipe);
  const double n = static_cast<double>(recipe.n);
  const double rounded
    = std::exp2(std::round(std::log2((std::max)(pairs_per_element, 1. / 16))));
  Recipe usual;
  usual.search = recipe.search;
  usual.n = recipe.n;
  usual.reach.factor
    = search.reach_of_pairs == 0
        ? 0.01 * std::pow(n, -2. / search.dimension)
        : std::pow(2 * rounded / n / search.reach_of_pairs, 1. / search.dimension);
  const std::string line = to_text(usual);
  const auto known = uniform_.find(line);
  if(known != uniform_.end())
    return known->second;
  const Made_scene scene = make_scene(usual, search.dimension);
  return uniform_[line] = least_of(search, scene, 9);
}

} // namespace thick_benchmark
