// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_tables.h"

#include "measuring/timing.h"
#include "scenes/object_generators.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace thick_benchmark {

namespace {

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
// boxes, and at most a fifth of the time of the best of the others.
constexpr double of_boxes = 0.5;
constexpr double of_best = 5;

void print_times(const Near_scene& scene, int rounds)
{
  std::vector<Near_method> methods = {near_objects(), grown_boxes()};
  for(const Near_method& method : other_methods(scene))
    methods.push_back(method);
  std::vector<Job> jobs;
  std::vector<std::size_t> pairs;
  for(const Near_method& method : methods) {
    const Run<Pair_list> run = method.prepare(scene);
    pairs.push_back(run().pairs.size());
    jobs.push_back(timed(run));
  }
  const std::vector<Seconds> times = time_in_turns(jobs, rounds, 0);
  std::vector<double> ratios;
  for(std::size_t k = 0; k < methods.size(); ++k)
    ratios.push_back(median(times, [=](const Seconds& s) { return s[k] / s[0]; }));
  const auto best = std::min_element(ratios.begin() + 2, ratios.end()) - ratios.begin();
  for(std::size_t k = 0; k < methods.size(); ++k) {
    const double target = k == 1 ? of_boxes : k == static_cast<std::size_t>(best) ? of_best : 0;
    std::ostringstream text;
    if(target != 0)
      text << ">= " << target;
    print_line(name_of(scene), methods[k].name, scene.objects.size(), pairs[k],
               1000 * median(times, [=](const Seconds& s) { return s[k]; }), ratios[k], text.str(),
               target == 0 ? "" : ratios[k] >= target ? "met" : "missed");
  }
}

} // namespace

void print_near_times(std::size_t n, int rounds)
{
  std::cout << '\n';
  print_head("scene", "n", "pairs", "ms", "time / ours", "target", "verdict");
  const double pairs_of_boxes = static_cast<double>(n) / 4;
  for(const Object_scene& objects :
      {uniform_segments(2, n, pairs_of_boxes), uniform_segments(3, n, pairs_of_boxes),
       uniform_triangles(n, pairs_of_boxes)})
    print_times(with_pair_each(objects), rounds);
}

} // namespace thick_benchmark
