// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The times of many methods on the same points, for charts, as CSV. Before a method is timed its
// pairs are compared with ours.

#include "compare/Contestant.h"
#include "table.h"

#include "measuring/speed_up.h"
#include "measuring/timing.h"
#include "methods/kd_tree.h"
#include "methods/nanoflann.h"
#include "methods/ours.h"
#include "scenes/generators.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace thick_benchmark {
namespace {

struct Uniform_scene
{
  int dimension;
  double neighbours; // k/n aimed at
  std::size_t n;
};

// The median of three times of at least 0.05 seconds. What takes more than a second is not
// repeated.
double seconds_of_run(const Contestant& method, const Scene& scene, const Tally& expected)
{
  const Run<Tally> run = method.prepare(scene);
  Tally found;
  const double first = seconds_of([&] { found = run(); });
  if(method.is_exact)
    check_equal(method.name, expected, found);
  if(first > 1)
    return first;
  const int count = static_cast<int>(std::ceil(0.05 / first));
  const auto run_often = [&] {
    for(int i = 0; i < count; ++i)
      found = run();
  };
  const std::vector<Seconds> times = time_in_turns({timed_by_the_clock(run_often)}, 3, 0);
  return median(times, [](const Seconds& s) { return s[0]; }) / count;
}

// Time against n, and against k/n.
std::vector<Uniform_scene> uniform_scenes(std::size_t max_n)
{
  std::vector<Uniform_scene> scenes;
  for(int d : {2, 3}) {
    for(std::size_t n = 1000; n <= max_n; n *= 10)
      for(double neighbours : {0.5, 10.})
        scenes.push_back({d, neighbours, n});
    for(double neighbours : {0.01, 0.1, 2., 40., 100.})
      scenes.push_back({d, neighbours, std::min<std::size_t>(max_n, 1000000)});
  }
  return scenes;
}

void add_trees(Contestants& all)
{
  const auto kd_tree = on_epick([](const auto& points, double r, Tally& tally) {
    kd_tree_search<Epick>(points, r, tally);
  });
  all.push_back({{"Kd_tree + Fuzzy_sphere", kd_tree}, false, 1000000});
#ifdef THICK_BENCHMARK_HAS_NANOFLANN
  const auto nanoflann = on_epick([](const auto& points, double r, Tally& tally) {
    nanoflann_search(points, nanoflann_closed(r), tally);
  });
  all.push_back({{"nanoflann", nanoflann}, false, 10000000});
#endif
}

Contestants all_contestants()
{
  Contestants all;
  add_ours(all);
  add_recursive_route(all);
  add_boxes(all);
  add_delaunay(all);
  add_trees(all);
  return all;
}

void print_times(const Uniform_scene& u, const Contestants& methods)
{
  const Scene scene = uniform(u.dimension, u.n, u.neighbours * static_cast<double>(u.n));
  const Tally expected = search_epick(scene).sequential();
  for(const Contestant& method : methods)
    if(u.n <= method.max_n)
      std::cout << u.dimension << "D," << u.neighbours << ',' << u.n << ",\"" << method.name
                << "\"," << expected.pairs << ','
                << 1000 * seconds_of_run(method, scene, expected) << std::endl;
}

} // namespace

void print_table(const Settings& settings)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Two_threads two_threads;
#endif
  std::cout << "dimension,neighbours,n,method,k,ms\n";
  for(const Uniform_scene& scene : uniform_scenes(settings.is_quick ? 10000 : 10000000))
    print_times(scene, all_contestants());
}

} // namespace thick_benchmark
