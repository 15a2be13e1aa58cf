// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "rows.h"

#include "print.h"

#include "measuring/speed_up.h"

namespace thick_benchmark {
namespace {

void print_row(const Row& row)
{
  print_line(row.name, row.n, row.k, row.milliseconds ? fixed(*row.milliseconds, 1) : "",
             row.quantity, figure(row.measured), target_of(row.goal), figure(row.goal.good),
             verdict(row.measured, row.goal), figure(row.machine_speed_up));
}

} // namespace

void print_rows(const Experiments& experiments, const Settings& settings)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Two_threads two_threads;
#endif
  print_head({"scene", ">n", ">k", ">ms", "quantity", ">measured", ">target", ">good", "verdict",
              ">machine"});
  for(const Experiment& experiment : experiments)
    if(experiment.name.find(settings.only) != std::string::npos)
      for(const Row& row : experiment.run())
        print_row(row);
}

Subject make_subject(const std::string& name, std::size_t n, const Search& search,
                     const Tally& expected)
{
  check_equal(name, expected, search.sequential());
  if(search.parallel)
    check_equal(name + " in parallel", expected, search.parallel());
  return {name, n, expected.pairs, search};
}

#ifdef CGAL_LINKED_WITH_TBB

Row measure_two_threads(const Subject& subject)
{
  const Search& search = subject.search;
  const Speed_up speed_up
    = measure_speed_up(search.sequential_like_parallel, search.parallel, search.sequential);
  // 1.7 and 1.9 where the machine gives 1.9.
  const Goal goal = {Goal::AT_LEAST, 0.9, 1.0};
  return {subject.name + ", 2 threads", "speed-up / machine", goal, speed_up.share, subject.n,
          subject.k, speed_up.milliseconds, speed_up.of_machine};
}

#endif // CGAL_LINKED_WITH_TBB

} // namespace thick_benchmark
