// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// bad_scenes: scenes that were bad once, and how much work per element and pair they take today.
//
//   bad_scenes [<search>]     measures those of one search, or all, with n, 4 n and 16 n elements
//
// It ends with status 1 if one of them takes more counted work than it may. Times are printed only.

#include "bad_scenes/Work.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

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

// How bad a scene is: its work per element and pair, over that of uniform points with as many
// elements and about as many pairs. Of two sets of uniform points, each is one half.
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
  std::optional<Factor> of(const Recipe& recipe)
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

private:
  // Pairs per element are rounded to a power of two, and to 2^-4 if they are fewer.
  Work uniform(const Recipe& recipe, double pairs_per_element)
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

  std::map<std::tuple<std::string, std::size_t, double>, Work> uniform_; // by search, n, and pairs
};

const double most_counted = 12; // times as much as for uniform elements

// Returns whether the scene takes no more than it may.
bool measure(const std::string& line, Factors& factors)
{
  bool is_good = true;
  Recipe recipe = read_recipe(line);
  std::cout << line << std::endl;
  for(recipe.n = 4000; recipe.n <= 64000; recipe.n *= 4) {
    const std::optional<Factor> factor = factors.of(recipe);
    std::cout << "  n = " << recipe.n << ": ";
    if(factor)
      std::cout << "counted " << factor->counted << ", time " << factor->time << ", k/n "
                << factor->pairs << std::endl;
    else
      std::cout << "too many pairs" << std::endl;
    is_good = is_good && (!factor || factor->counted <= most_counted);
  }
  return is_good;
}

} // namespace
} // namespace thick_benchmark

int main(int argc, char** argv)
try {
  using namespace thick_benchmark;
  std::cout << std::setprecision(3);
  Factors factors;
  bool are_good = true;
  for(const char* line : known_recipes())
    if(argc < 2 || read_recipe(line).search == argv[1])
      are_good = measure(line, factors) && are_good;
  return are_good ? 0 : 1;
}
catch(const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
