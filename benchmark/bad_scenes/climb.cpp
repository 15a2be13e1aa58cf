// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/climb.h"

#include "bad_scenes/mutate.h"
#include "measuring/timing.h"

#include <algorithm>
#include <utility>

namespace thick_benchmark {
namespace {

// A climb ends after so many mutations without a worse scene.
const int max_misses = 60;

const int usual_rounds = 3;

// A find is worse than another one if its score is so much higher: times are not exact.
const double min_gain = 1.05;

double clock_now()
{
  static const Stopwatch watch;
  return watch.seconds();
}

} // namespace

double Find::score() const
{
  const double small = factor.larger(), large = larger_factor.larger();
  return small == 0 ? 0 : large * std::clamp(large / small, 0.25, 4.);
}

Climb::Climb(const Climb_options& options, unsigned int seed, const Show& show)
  : options_(options), show_(show), random_(seed)
{}

Find Climb::run(const std::vector<Recipe>& known)
{
  const double end = clock_now() + options_.seconds;
  for(std::size_t number = 0; clock_now() < end; ++number) {
    Find find = climb(look_at(start(known, number), 0, usual_rounds), end);
    if(find.score() > options_.noteworthy) {
      find = shorten(find);
      show_(find);
    }
    keep(find);
  }
  return finds_.front();
}

// Measures a recipe at n, and at 4 n if its factor at n is larger than the given one.
Find Climb::look_at(const Recipe& recipe, double least_factor, int rounds)
{
  ++count_;
  Find find;
  find.recipe = recipe;
  find.factor = factors_.of(recipe, rounds);
  if(find.factor.larger() <= least_factor)
    return find;
  Recipe larger = recipe;
  larger.n *= 4;
  find.larger_factor = factors_.of(larger, rounds);
  return find;
}

Find Climb::climb(Find find, double end)
{
  const int dimension = search_of(find.recipe).dimension;
  for(int misses = 0; misses < max_misses && clock_now() < end; ++misses) {
    const Recipe& other
      = finds_.empty() ? find.recipe : finds_[random_() % finds_.size()].recipe;
    const Recipe mutant = mutate(find.recipe, other, dimension, random_);
    Find next = look_at(mutant, find.factor.larger() / 2, 1);
    if(next.score() > min_gain * find.score())
      next = look_at(mutant, 0, usual_rounds); // the time may have been a slip
    if(next.score() > min_gain * find.score()) {
      find = next;
      misses = 0;
    }
  }
  return find;
}

// Leaves out changes that are not needed for most of the score.
Find Climb::shorten(Find find)
{
  for(std::size_t i = find.recipe.changes.size(); i-- > 0;) {
    Recipe shorter = find.recipe;
    shorter.changes.erase(shorter.changes.begin() + static_cast<std::ptrdiff_t>(i));
    const Find next = look_at(shorter, 0, usual_rounds);
    if(next.score() > 0.8 * find.score())
      find = next;
  }
  return find;
}

void Climb::keep(const Find& find)
{
  const std::size_t max_finds = 12;
  finds_.push_back(find);
  std::sort(finds_.begin(), finds_.end(),
            [](const Find& a, const Find& b) { return a.score() > b.score(); });
  finds_.resize((std::min)(finds_.size(), max_finds));
}

// The known recipes, one after the other; then every other climb starts from a find, and every
// other one from a few random changes.
Recipe Climb::start(const std::vector<Recipe>& known, std::size_t number)
{
  if(number < known.size())
    return known[number];
  Recipe recipe;
  recipe.search = options_.search;
  const int dimension = search_of(recipe).dimension;
  recipe.n = options_.n;
  recipe.reach = {1, false, number % 4 == 1 ? 1 : 1. / dimension};
  if(number % 2 == 0 && !finds_.empty())
    recipe = finds_[random_() % finds_.size()].recipe;
  return mutate(recipe, recipe, dimension, random_);
}

} // namespace thick_benchmark
