// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What a measurement depends on besides the program: the machine, the compiler, the version.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_RUN_FACTS_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_RUN_FACTS_H

#include <iosfwd>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Run_fact
{
  std::string name;
  std::string value;
};

std::vector<Run_fact> run_facts();

void print_run_facts(std::ostream& out); // a list in Markdown

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_RUN_FACTS_H
