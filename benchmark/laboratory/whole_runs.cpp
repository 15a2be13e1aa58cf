// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The time of whole searches and their wrong pairs, for all methods: on random points, on a lattice
// full of exact ties, and on one of near misses.
//
//   whole_runs <folder for whole_runs.csv> <random points> <points per lattice row>

#include "measuring/Csv_file.h"
#include "wrong_pairs.h"

#include "support/box_oracle.h"

#include <iostream>

namespace {

using namespace test_support;

std::vector<Point_scene> scenes(std::size_t n, std::size_t row)
{
  const double root = std::sqrt(static_cast<double>(n));
  const double odd_45_bits = 23456789012345;
  return {
    {"random", 2, uniform_points(2, n, 0, 1, 1), Radius::of_length(1 / root), std::nullopt},
    {"exact ties", 2, shuffled(lattice_points(2, row, odd_45_bits), 2),
     Radius::of_length(5 * odd_45_bits), std::nullopt},
    {"near misses", 2, shuffled(lattice_points(2, row, 0.1), 3), Radius::of_length(0.5),
     std::nullopt},
  };
}

// Runs a method five times, or once if that is long; keeps the least time, in which the machine did
// the least besides.
std::string find_often(const lab::Method& method, const Point_scene& scene, lab::Found& found)
{
  constexpr unsigned int seconds = 120;
  const std::string status = lab::find_in_child(method, scene, seconds, found).status;
  for(int repetition = 1; repetition < 5 && status == "ok" && found.seconds < 1; ++repetition) {
    lab::Found again;
    lab::find_in_child(method, scene, seconds, again);
    found.seconds = std::min(found.seconds, again.seconds);
  }
  return status;
}

} // namespace

int main(int, char** arguments)
{
  lab::Csv_file csv(std::string(arguments[1]) + "/whole_runs.csv",
                    "boxes rounded outwards, then GMP integers (test/support/box_oracle.h)",
                    "set,points,true_pairs,method,group,status,seconds,missing,extra");
  for(const Point_scene& scene : scenes(std::stoul(arguments[2]), std::stoul(arguments[3]))) {
    const Pairs truth = box_pairs(scene);
    std::cout << scene << ", " << truth.size() << " pairs" << std::endl;
    for(const lab::Method& method : lab::all_methods(2)) {
      lab::Found found;
      const std::string status = find_often(method, scene, found);
      const Pairs_difference wrong
        = status == "ok" ? compare(truth, lab::reported(found)) : Pairs_difference();
      csv.row(scene.name, scene.points.size(), truth.size(), method.name, method.group, status,
              found.seconds, wrong.missing.size(), wrong.extra.size());
    }
  }
}
