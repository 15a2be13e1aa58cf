// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points in a cube that repeats, by our search and by what simulations use.

#include "counted.h"
#include "print.h"
#include "table.h"

#include "methods/periodic_methods.h"

#include "support/point_generators.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace thick_benchmark {

namespace {

// Points in the unit cube, about 10 pairs for each.
Periodic_scene uniform_scene(std::size_t n)
{
  constexpr double pi = 3.14159265358979323846;
  Periodic_scene scene = {"uniform, n = " + std::to_string(n), {}, {}, 0};
  for(const auto& c : test_support::uniform_points(3, n, 0, 1, 1))
    scene.points.push_back({c[0], c[1], c[2]});
  for(std::size_t k = 0; k < 3; ++k)
    scene.vectors[k][k] = 1;
  scene.r = std::cbrt(15 / (pi * static_cast<double>(n)));
  return scene;
}

std::vector<Periodic_method> methods()
{
  std::vector<Periodic_method> methods
    = {periodic_stored(), periodic_counted(), points_without_periods(), periodic_lists()};
#ifdef THICK_BENCHMARK_HAS_VESIN
  methods.push_back(vesin_half_list());
  methods.push_back(vesin_full_list());
#endif
  return methods;
}

Image_pairs sorted_pairs(const Periodic_method& method, const Periodic_scene& scene)
{
  Image_pairs pairs = method.prepare(scene).pairs();
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Random points have no ties, so that methods agree, whether they are exact or not.
void check_pairs(const Periodic_scene& scene)
{
  const Image_pairs pairs = sorted_pairs(periodic_stored(), scene);
  for(const Periodic_method& method : methods())
    if(sorted_pairs(method, scene) != pairs)
      throw std::runtime_error(method.name + " finds other pairs");
}

// Searches are compared by their pairs, and then timed.
void print_times(const Periodic_scene& scene, int rounds)
{
  check_pairs(scene);
  std::vector<Counted> ways;
  for(const Periodic_method& method : methods())
    ways.push_back({method.name, method.prepare(scene).count});
  for(const Counted_times& one : time_in_turns(ways, rounds))
    print_line(scene.name, one.name, one.count, digits(one.least, 4), digits(one.over_first, 4),
               digits(one.over_second, 4));
}

} // namespace

void print_table(const Settings& settings)
{
  print_head({"scene", "method", ">found", ">ms", ">/ stored", ">/ counted"});
  std::vector<std::size_t> sizes = {100000, 1000000};
  if(settings.is_quick)
    sizes = {3000};
  for(const std::size_t n : sizes)
    print_times(uniform_scene(n), settings.is_quick ? 1 : 7);
}

} // namespace thick_benchmark
