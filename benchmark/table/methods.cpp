// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The times of many methods on the same points, for charts, as CSV. Before a method is timed its
// pairs are compared with ours.

#include "compare/Contestant.h"
#include "table.h"

#include "measuring/speed_up.h"
#include "measuring/timing.h"
#include "methods/ours.h"
#include "scenes/generators.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace thick_benchmark {
namespace {

struct Scene_kind
{
  std::string name;  // for the first columns: the dimension, the scene, k/n aimed at
  bool has_variants; // whether the variants of methods are measured as well
  std::function<Scene()> make;
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

std::string columns(int dimension, const char* kind, double neighbours)
{
  std::ostringstream text;
  text << dimension << "D," << kind << ',' << neighbours;
  return text.str();
}

// Time against n, against k/n, and on other scenes.
std::vector<Scene_kind> scene_kinds(std::size_t max_n)
{
  std::vector<Scene_kind> kinds;
  const std::size_t n = std::min<std::size_t>(max_n, 1000000);
  const auto add_uniform = [&](int d, double neighbours, std::size_t size, bool has_variants) {
    kinds.push_back({columns(d, "uniform", neighbours), has_variants, [=] {
                       return uniform(d, size, neighbours * static_cast<double>(size));
                     }});
  };
  for(int d : {2, 3}) {
    for(std::size_t size = 1000; size <= max_n; size *= 10)
      for(double neighbours : {0.5, 10.})
        add_uniform(d, neighbours, size, true);
    for(double neighbours : {0.01, 0.1, 2., 40., 100.})
      add_uniform(d, neighbours, n, false);
    kinds.push_back({columns(d, "clusters", 2), false, [=] {
                       return with_fitting_distance(clusters(d, n), count_pairs);
                     }});
  }
  return kinds;
}

Contestants all_contestants()
{
  Contestants all;
  add_ours(all);
  add_recursive_routes(all);
  add_boxes(all);
  add_delaunay_epick(all);
  add_delaunay_epeck(all);
  add_trees(all);
  return all;
}

void print_times(const Scene_kind& kind, const Contestants& methods)
{
  const Scene scene = kind.make();
  const Tally expected = search_epick(scene).sequential();
  for(const Contestant& method : methods)
    if(scene.size() <= method.max_n && (kind.has_variants || !method.is_variant))
      std::cout << kind.name << ',' << scene.size() << ",\"" << method.name << "\","
                << expected.pairs << ',' << 1000 * seconds_of_run(method, scene, expected)
                << std::endl;
}

} // namespace

void print_table(const Settings& settings)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Two_threads two_threads;
#endif
  std::cout << "dimension,kind,neighbours,n,method,k,ms\n";
  for(const Scene_kind& kind : scene_kinds(settings.is_quick ? 10000 : 10000000))
    print_times(kind, all_contestants());
}

} // namespace thick_benchmark
