// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segments and triangles within a distance, and rays, by our searches and by what else there is:
// times, and how many pairs are wrong.

#include "counted.h"
#include "goal.h"
#include "print.h"
#include "table.h"

#include "methods/near_methods.h"
#include "scenes/object_generators.h"
#include "scenes/touching_generators.h"

#include <algorithm>
#include <cmath>

namespace thick_benchmark {
namespace {

// Those of others, as far as their libraries are there.
std::vector<Near_method> other_methods([[maybe_unused]] const Near_scene& scene)
{
  std::vector<Near_method> methods = {near_by_boxes(10), near_by_boxes(1000)};
#ifdef THICK_BENCHMARK_HAS_EMBREE
  if(scene.objects.dimension == 3)
    methods.push_back(near_by_embree());
#endif
  return methods;
}

std::string name_of(const Near_scene& scene)
{
  return std::to_string(scene.objects.dimension) + "D "
         + (scene.objects.shape == Shape::SEGMENT ? "segments, " : "triangles, ") + scene.name;
}

// ---- times --------------------------------------------------------------------------------------

// The objects, within a distance that .9 to 1.1 times as many pairs have. It grows by a factor that
// shrinks whenever there are too many pairs.
Near_scene with_pair_each(const Object_scene& objects)
{
  Near_scene scene = {"uniform", objects, 1e-6};
  const double n = static_cast<double>(objects.size());
  const auto pairs_each = [&] {
    return static_cast<double>(near_by_boxes(1000).prepare(scene)().pairs.size()) / n;
  };
  double factor = 4;
  for(double each = pairs_each(); each < 0.9 || each > 1.1; each = pairs_each()) {
    if(each > 1.1) {
      scene.r /= factor;
      factor = std::sqrt(factor);
    }
    scene.r *= factor;
  }
  return scene;
}

// The first method is ours. It is to take at most twice the time of the second, the search of
// boxes, and at most a fifth of the time of the best of the others but the third. That one is ours
// as well, and is to take at most 1.15 times its time.
void print_times(const Near_scene& scene, int rounds)
{
  std::vector<Counted> ways;
  const auto add = [&](const Near_method& method) {
    ways.push_back({method.name, [run = method.prepare(scene)] { return run().pairs.size(); }});
  };
  add(near_objects());
  add(grown_boxes());
  add(thickened_objects());
  for(const Near_method& method : other_methods(scene))
    add(method);
  const std::vector<Counted_times> all = time_in_turns(ways, rounds);
  const auto best = std::min_element(all.begin() + 3, all.end(),
                                     [](auto& a, auto& b) { return a.over_first < b.over_first; });
  for(auto one = all.begin(); one != all.end(); ++one) {
    Goal goal;
    if(one == all.begin() + 2)
      goal = at_most(1.15);
    else if(one == all.begin() + 1 || one == best)
      goal = at_least(one == best ? 5 : 0.5);
    print_line(name_of(scene), one->name, scene.objects.size(), one->count, digits(one->median),
               figure(one->over_first), target_of(goal), verdict(one->over_first, goal));
  }
}

void print_all_times(std::size_t n, int rounds)
{
  print_head({"scene", "method", ">n", ">pairs", ">ms", ">time / ours", ">target", "verdict"});
  const double pairs_of_boxes = static_cast<double>(n) / 4;
  for(const Object_scene& objects :
      {uniform_segments(2, n, pairs_of_boxes), uniform_segments(3, n, pairs_of_boxes),
       uniform_triangles(n, pairs_of_boxes)})
    print_times(with_pair_each(objects), rounds);
}

// ---- wrong pairs --------------------------------------------------------------------------------

std::vector<Near_scene> scenes_of_ties(std::size_t n)
{
  std::vector<Near_scene> scenes;
  for(const double step : {1., .1})
    for(const int dimension : {2, 3})
      for(const Shape shape : {Shape::SEGMENT, Shape::TRIANGLE})
        scenes.push_back(lattice_scene(shape, dimension, n, step));
  scenes.push_back({"streets, touching", streets(n), 0});
  scenes.push_back({"rows, touching", rows_of_triangles(n), 0});
  scenes.push_back({"beams, touching", frame_of_beams(n), 0});
  scenes.push_back({"terrain, touching", terrain(n), 0});
  scenes.push_back({"bricks, touching", bricks_of_decimals(n), 0});
  scenes.push_back({"walls, touching", walls_on_floors(n), 0});
  return scenes;
}

void print_wrong_pairs(std::size_t n)
{
  std::cout << "\nWrong pairs, beside the oracle of the tests.\n\n";
  print_head({"scene", "method", ">n", ">pairs", ">missing", ">extra"});
  for(const Near_scene& scene : scenes_of_ties(n)) {
    const Pair_list right = near_pairs_by_oracle(scene);
    std::vector<Near_method> methods = other_methods(scene);
    methods.insert(methods.begin(), near_objects());
    for(const Near_method& method : methods) {
      const Pair_list found = method.prepare(scene)();
      print_line(name_of(scene), method.name, scene.objects.size(), right.pairs.size(),
                 count_missing(right, found), count_missing(found, right));
    }
  }
}

// ---- rays ---------------------------------------------------------------------------------------

void print_rays(std::size_t n, int rounds)
{
  std::cout << "\nLong rays among small triangles.\n\n";
  print_head({"rays", "method", ">found", ">ms", ">time / ours", ">target", "verdict"});
  for(const std::size_t triangles : {n / 10, n}) {
    const std::string name = std::to_string(triangles / 10) + " rays, "
                             + std::to_string(triangles) + " triangles";
    Goal goal;
    for(const Counted_times& one :
        time_in_turns(ways_of_rays(triangles / 10, triangles), rounds)) {
      print_line(name, one.name, one.count, digits(one.median), figure(one.over_first),
                 target_of(goal), verdict(one.over_first, goal));
      goal = at_least(1. / 3); // ours may take three times as long as the tree
    }
  }
}

} // namespace

void print_table(const Settings& settings)
{
  const bool is_quick = settings.is_quick;
  const int rounds = is_quick ? 1 : 7;
  print_all_times(is_quick ? 3000 : 300000, rounds);
  print_wrong_pairs(is_quick ? 300 : 3000);
  print_rays(is_quick ? 2000 : 200000, rounds);
}

} // namespace thick_benchmark
