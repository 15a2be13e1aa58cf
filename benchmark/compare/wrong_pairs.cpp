// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "near_tables.h"

#include "scenes/touching_generators.h"

#include <algorithm>
#include <iterator>

namespace thick_benchmark {

namespace {

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

// How many pairs of `a` are not in `b`.
std::size_t count_missing(Pair_list a, Pair_list b)
{
  std::sort(a.pairs.begin(), a.pairs.end());
  std::sort(b.pairs.begin(), b.pairs.end());
  Pair_list missing;
  std::set_difference(a.pairs.begin(), a.pairs.end(), b.pairs.begin(), b.pairs.end(),
                      std::back_inserter(missing.pairs));
  return missing.pairs.size();
}

} // namespace

void print_wrong_pairs(std::size_t n)
{
  std::cout << "\nWrong pairs, beside the oracle of the tests.\n\n";
  print_head("scene", "n", "pairs", "missing", "extra");
  for(const Near_scene& scene : scenes_of_ties(n)) {
    const Pair_list right = near_pairs_by_oracle(scene);
    std::vector<Near_method> methods = {near_objects()};
    for(const Near_method& method : other_methods(scene))
      methods.push_back(method);
    for(const Near_method& method : methods) {
      const Pair_list found = method.prepare(scene)();
      print_line(name_of(scene), method.name, scene.objects.size(), right.pairs.size(),
                 count_missing(right, found), count_missing(found, right));
    }
  }
}

} // namespace thick_benchmark
