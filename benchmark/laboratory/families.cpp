// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// All families of difficult scenes by all methods: the pairs that are missing, extra, asymmetric,
// or depend on the order of the input.
//
//   families <folder for families.csv>

#include "measuring/Csv_file.h"
#include "wrong_pairs.h"

#include "support/brute_force.h"
#include "support/robustness_families.h"

#include <iostream>

int main(int, char** arguments)
{
  constexpr unsigned int seconds = 60;
  lab::Csv_file csv(std::string(arguments[1]) + "/families.csv",
                    "all pairs in GMP integers (test/support/brute_force.h, brute_force)",
                    "dimension,family,true_pairs,at_the_radius,method,group,status,missing,extra,"
                    "asymmetric,order_dependent,seconds");
  for(int dimension : {2, 3}) {
    const std::vector<lab::Method> methods = lab::all_methods(dimension);
    for(const auto& scene : test_support::robustness_families(dimension)) {
      std::cout << scene << std::endl;
      const test_support::Truth truth = test_support::brute_force(scene.points, scene.radius);
      for(const lab::Method& method : methods) {
        const lab::Wrong_pairs wrong
          = lab::count_wrong_pairs(method, scene, truth.pairs, seconds);
        csv.row(dimension, scene.name, truth.pairs.size(), truth.boundary, method.name,
                method.group, wrong.status, wrong.missing, wrong.extra, wrong.asymmetric,
                lab::count_order_dependent(method, scene, seconds), wrong.seconds);
      }
    }
  }
}
