// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Closed meshes that intersect, by our search and by what else there is.

#include "counted.h"
#include "goal.h"
#include "print.h"
#include "table.h"

#include "methods/solid_methods.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace thick_benchmark {
namespace {

// The first method is ours. It may take twice the time of the second, the search of the boxes of
// all faces, and 60 nanoseconds for each pair that this finds. It is to take at most a fifth of the
// time of each other method.
void print_times(const Solid_scene& scene, int rounds)
{
  std::vector<Solid_method> methods = {solids_ours(), boxes_of_faces(), solids_by_pmp()};
#ifdef THICK_BENCHMARK_HAS_FCL
  methods.push_back(solids_by_fcl());
#endif
  std::vector<Counted> ways;
  std::size_t faces = 0;
  for(const Mesh_scene& solid : scene.solids)
    faces += solid.faces.size();
  for(const Solid_method& method : methods)
    ways.push_back({method.name, method.prepare(scene)});
  const std::vector<Counted_times> all = time_in_turns(ways, rounds);
  if(all[2].count != all[0].count)
    throw std::runtime_error(scene.name + ": the counts of pairs of PMP and ours differ.");
  for(std::size_t k = 0; k < all.size(); ++k) {
    const double allowed = 2 * all[1].median + 60e-6 * static_cast<double>(all[1].count);
    const double measured = k == 1 ? allowed / all[0].median : all[k].over_first;
    const std::string what = k == 0   ? ""
                             : k == 1 ? "2 boxes + 60 ns K, " + figure(measured)
                                      : figure(measured);
    const Goal goal = k == 0 ? Goal() : at_least(k == 1 ? 1 : 5);
    print_line(scene.name, all[k].name, scene.solids.size(), faces, all[k].count,
               digits(all[k].median), what, target_of(goal), verdict(measured, goal));
  }
}

} // namespace

void print_table(const Settings& settings)
{
  const bool is_quick = settings.is_quick;
  const int rounds = is_quick ? 1 : 3;
  print_head({"scene", "method", ">meshes", ">faces", ">pairs", ">ms", ">time / ours", ">target",
              "verdict"});
  print_times(machine_parts(is_quick ? 300 : 10000), rounds);
  print_times(building(is_quick ? 300 : 20000), rounds);
}

} // namespace thick_benchmark
