// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// All families of difficult scenes by all methods: the pairs that are missing, extra, asymmetric,
// or depend on the order of the input.
//
//   families <folder for families.csv>

#include "wrong_pairs.h"

#include "measuring/Csv_file.h"

#include "support/brute_force.h"
#include "support/robustness_families.h"

#include <iostream>

int main(int, char** arguments)
{
  using namespace lab;
  constexpr unsigned int seconds = 60;
  Csv_file csv(arguments[1], "families.csv",
               "all pairs in GMP integers (test/support/brute_force.h, brute_force)",
               "dimension,family,true_pairs,at_the_radius,method,group,status,missing,extra,"
               "asymmetric,order_dependent,seconds");
  for(int dimension : {2, 3})
    for(const auto& family : test_support::robustness_families(dimension)) {
      std::cout << family << std::endl;
      const test_support::Truth truth = test_support::brute_force(family.points, family.radius);
      const Scene scene = scene_of(family);
      for(const Column& column : all_columns()) {
        const Outcome outcome = find_in_child(column, scene, seconds);
        const auto wrong = wrong_pairs(outcome, truth.pairs);
        csv.row(dimension, scene.name, truth.pairs.size(), truth.boundary, column.name,
                column.group, outcome.status, wrong.missing.size(), wrong.extra.size(),
                count_asymmetric(outcome.found), count_order_dependent(column, scene, seconds),
                outcome.seconds);
      }
    }
}
