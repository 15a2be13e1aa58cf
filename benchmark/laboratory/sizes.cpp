// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Families of sizes: rectangles, cuboids and balls whose sizes differ more and more, by all methods
// that search objects: the time of the search, and the pairs that are missing or extra.
//
//   sizes <folder for sizes.csv> <objects> <objects if all of them meet>

#include "families_of_sizes.h"
#include "object_columns.h"
#include "wrong_pairs.h"

#include "measuring/Csv_file.h"
#include "measuring/timing.h"

#include <algorithm>
#include <iostream>

namespace {

using namespace lab;

// The least time of up to five runs, in seconds of the processor, or 0 if none comes to its end.
double seconds_of_search(const Object_column& column, const Object_scene& scene, unsigned int limit)
{
  const auto measure = [&] {
    const Run<Tally> run = column.prepare_count(scene);
    double least = processor_seconds_of(run);
    for(int repetition = 1; repetition < 5 && least < 1; ++repetition)
      least = std::min(least, processor_seconds_of(run));
    return std::vector<double>{least};
  };
  const Child_result<double> result = run_in_child(limit, measure);
  return result.is_ok() ? result.values[0] : 0;
}

void write_rows(const Family& family, Csv_file& csv)
{
  constexpr unsigned int limit = 120; // seconds
  const Pairs truth = true_pairs(family.scene);
  std::cout << family.shape << ", " << family.name << ", " << truth.size() << " pairs" << std::endl;
  for(const Object_column& column : object_columns(family.scene.shape)) {
    const Outcome outcome = find_in_child<Object_scene>(column, family.scene, limit);
    const auto wrong = wrong_pairs(outcome, truth);
    const double seconds = outcome.is_ok() ? seconds_of_search(column, family.scene, limit) : 0;
    csv.row(family.shape, family.name, family.scene.size(), truth.size(), column.name,
            column.group, outcome.status, seconds, wrong.missing.size(), wrong.extra.size());
  }
}

} // namespace

int main(int, char** arguments)
{
  const std::size_t n = std::stoul(arguments[2]), dense = std::stoul(arguments[3]);
  Csv_file csv(arguments[1], "sizes.csv",
               "a sweep along an axis, then GMP rationals (laboratory/families_of_sizes.h)",
               "shape,family,objects,true_pairs,method,group,status,seconds,missing,extra");
  for(const Family& family : families_of_sizes(n, dense))
    write_rows(family, csv);
}
