// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The pairs that searches of domains that repeat lose or find too often on perfect lattices, within
// distances that pairs are exactly or nearly at.
//
//   periodic_pairs <folder for periodic_pairs.csv> <points per lattice row>

#include "measuring/Csv_file.h"
#include "methods/periodic_methods.h"
#include "support/periodic_oracle.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace thick_benchmark;
using test_support::Rational;
using Pairs_of_images = std::vector<test_support::Image_pair<3>>;
using Steps = std::array<std::array<int, 3>, 3>; // of a lattice, for each period

// The points of a cube of the lattice with a unit, in a domain whose periods are lattice vectors.
Periodic_scene lattice(const std::string& name, int row, double unit, const Steps& steps, double r)
{
  Periodic_scene scene = {name, {}, {}, r};
  for(int x = 0; x < row; ++x)
    for(int y = 0; y < row; ++y)
      for(int z = 0; z < row; ++z)
        scene.points.push_back({unit * x, unit * y, unit * z});
  for(std::size_t k = 0; k < 3; ++k)
    for(std::size_t axis = 0; axis < 3; ++axis)
      scene.vectors[k][axis] = unit * steps[k][axis];
  return scene;
}

std::vector<Periodic_scene> scenes(int row)
{
  const Steps straight = {{{row, 0, 0}, {0, row, 0}, {0, 0, row}}};
  const Steps skewed = {{{row, 0, 0}, {3, row, 0}, {-2, 4, row}}};
  std::vector<Periodic_scene> scenes;
  for(const auto& [unit_name, unit] :
      std::vector<std::pair<std::string, double>>{{"1", 1}, {"0.1", 0.1}, {"1/3", 1 / 3.}})
    for(const auto& [bound_name, r] : std::vector<std::pair<std::string, double>>{
          {"1", unit}, {"2", 2 * unit}, {"sqrt 2", std::sqrt(2.) * unit}})
      for(const auto& [domain_name, steps] :
          std::vector<std::pair<std::string, Steps>>{{"straight", straight}, {"skewed", skewed}})
        scenes.push_back(lattice(domain_name + ", unit " + unit_name + ", r = " + bound_name, row,
                                 unit, steps, r));
  return scenes;
}

// The scene as the oracle of the tests takes it.
test_support::Lattice_scene<3> in_numbers(const Periodic_scene& scene)
{
  test_support::Lattice_scene<3> result;
  for(const auto& p : scene.points)
    result.points.emplace_back(p.begin(), p.end());
  for(std::size_t k = 0; k < 3; ++k) {
    result.repeats[k] = true;
    for(std::size_t axis = 0; axis < 3; ++axis)
      result.vectors[k][axis] = Rational(scene.vectors[k][axis]);
  }
  result.square = Rational(scene.r) * Rational(scene.r);
  return result;
}

// The pairs within the distance, in ascending order, and of these the ones that are exactly at it.
struct Truth
{
  Pairs_of_images pairs, ties;
};

Truth truth_of(const Periodic_scene& scene)
{
  const test_support::Lattice_scene<3> exact = in_numbers(scene);
  const test_support::Periodic_oracle<3> oracle(exact);
  Truth truth = {oracle.pairs(), {}};
  for(const auto& pair : truth.pairs)
    if(oracle.square(pair) == exact.square)
      truth.ties.push_back(pair);
  return truth;
}

Pairs_of_images found_by(const Periodic_method& method, const Periodic_scene& scene)
{
  const Image_pairs found = method.prepare(scene).pairs();
  Pairs_of_images pairs(found.begin(), found.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// The sorted pairs that are not in others, with repetitions.
Pairs_of_images difference(const Pairs_of_images& pairs, const Pairs_of_images& others)
{
  Pairs_of_images difference;
  std::set_difference(pairs.begin(), pairs.end(), others.begin(), others.end(),
                      std::back_inserter(difference));
  return difference;
}

std::vector<Periodic_method> methods()
{
  std::vector<Periodic_method> methods = {periodic_stored()};
#ifdef THICK_BENCHMARK_HAS_VESIN
  methods.push_back(vesin_half_list());
#endif
  return methods;
}

} // namespace

int main(int, char** arguments)
{
  Csv_file csv(arguments[1], "periodic_pairs.csv",
               "all pairs and offsets, in GMP rationals (test/support/periodic_oracle.h)",
               "scene,points,true_pairs,at_the_radius,method,rule,missing,extra");
  for(const Periodic_scene& scene : scenes(std::stoi(arguments[2]))) {
    const Truth truth = truth_of(scene);
    std::cout << scene.name << ", " << truth.pairs.size() << " pairs" << std::endl;
    for(const Periodic_method& method : methods()) {
      const Pairs_of_images expected
        = method.is_open ? difference(truth.pairs, truth.ties) : truth.pairs;
      const Pairs_of_images found = found_by(method, scene);
      csv.row(scene.name, scene.points.size(), expected.size(), truth.ties.size(),
              method.name.substr(0, method.name.find(',')), method.is_open ? "<" : "<=",
              difference(expected, found).size(), difference(found, expected).size());
    }
  }
}
