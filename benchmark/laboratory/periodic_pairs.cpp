// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The pairs that searches of domains that repeat lose or find too often on perfect lattices, within
// distances that pairs are exactly or nearly at.
//
//   periodic_pairs <folder for periodic_pairs.csv> <points per lattice row> [<folder for scenes>]
//
// The scenes are written for benchmark/compare/periodic_rivals.py, which adds rows.

#include "measuring/Csv_file.h"
#include "methods/periodic_methods.h"
#include "methods/periodic_scene_file.h"

#include <boost/multiprecision/gmp.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace thick_benchmark;
using Rational = boost::multiprecision::mpq_rational;
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

// All pairs within the distance, of which some are exactly at it.
struct Truth
{
  Image_pairs pairs;
  std::vector<bool> are_ties;
};

int compare_exactly(const Periodic_scene& scene, const Image_pair& pair)
{
  Rational sum = 0;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    Rational d = Rational(scene.points[static_cast<std::size_t>(pair.i)][axis])
                 - Rational(scene.points[static_cast<std::size_t>(pair.j)][axis]);
    for(std::size_t k = 0; k < 3; ++k)
      d -= pair.offset[k] * Rational(scene.vectors[k][axis]);
    sum += d * d;
  }
  return sum.compare(Rational(Rational(scene.r) * Rational(scene.r)));
}

// Tries all pairs and all offsets that any of these scenes needs. Rationals decide what doubles may
// not decide.
Truth truth_of(const Periodic_scene& scene)
{
  constexpr int most = 2;
  Truth truth;
  const auto size = static_cast<std::int32_t>(scene.points.size());
  Image_pair pair = {};
  std::array<std::int32_t, 3>& o = pair.offset;
  for(o[0] = -most; o[0] <= most; ++o[0])
    for(o[1] = -most; o[1] <= most; ++o[1])
      for(o[2] = -most; o[2] <= most; ++o[2]) {
        std::array<double, 3> move = {};
        for(std::size_t k = 0; k < 3; ++k)
          for(std::size_t axis = 0; axis < 3; ++axis)
            move[axis] += o[k] * scene.vectors[k][axis];
        for(pair.i = 0; pair.i < size; ++pair.i)
          for(pair.j = pair.i + 1; pair.j < size; ++pair.j) {
            double square = 0;
            for(std::size_t axis = 0; axis < 3; ++axis) {
              const double d = scene.points[static_cast<std::size_t>(pair.i)][axis]
                               - scene.points[static_cast<std::size_t>(pair.j)][axis] - move[axis];
              square += d * d;
            }
            if(square > scene.r * scene.r * 1.001)
              continue;
            const int sign = compare_exactly(scene, pair);
            if(sign <= 0) {
              truth.pairs.push_back(pair);
              truth.are_ties.push_back(sign == 0);
            }
          }
      }
  return truth;
}

// How many of the sorted pairs are not in others, with repetitions.
std::size_t size_of_difference(const Image_pairs& pairs, const Image_pairs& others)
{
  Image_pairs difference;
  std::set_difference(pairs.begin(), pairs.end(), others.begin(), others.end(),
                      std::back_inserter(difference));
  return difference.size();
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

int main(int count, char** arguments)
{
  Csv_file csv(arguments[1], "periodic_pairs.csv",
               "all pairs and offsets, in GMP rationals (benchmark/laboratory/periodic_pairs.cpp)",
               "scene,points,true_pairs,at_the_radius,method,rule,missing,extra");
  for(const Periodic_scene& scene : scenes(std::stoi(arguments[2]))) {
    const Truth truth = truth_of(scene);
    const auto ties = std::count(truth.are_ties.begin(), truth.are_ties.end(), true);
    std::cout << scene.name << ", " << truth.pairs.size() << " pairs" << std::endl;
    if(count > 3)
      write_scene(arguments[3], scene, truth.pairs, truth.are_ties);
    for(const Periodic_method& method : methods()) {
      Image_pairs expected;
      for(std::size_t k = 0; k < truth.pairs.size(); ++k)
        if(!method.is_open || !truth.are_ties[k])
          expected.push_back(truth.pairs[k]);
      Image_pairs found = method.prepare(scene).pairs();
      std::sort(expected.begin(), expected.end());
      std::sort(found.begin(), found.end());
      csv.row(scene.name, scene.points.size(), expected.size(), ties,
              method.name.substr(0, method.name.find(',')),
              method.is_open ? "<" : "<=", size_of_difference(expected, found),
              size_of_difference(found, expected));
    }
  }
}
