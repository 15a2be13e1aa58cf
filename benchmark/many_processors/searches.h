// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches that are measured by many processors, or as if there were many.

#ifndef THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_SEARCHES_H
#define THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_SEARCHES_H

#include "measuring/Tally.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace thick_benchmark {

// One search, in sequence and in parallel. Both leave what they found for found(), which takes it
// away. Pairs of all searches are counted together.
struct Many_search
{
  std::function<void()> sequential;
  std::function<void()> parallel;
  std::function<Tally()> found;
};

struct Many_row
{
  std::string name;
  double target; // how many times as fast as in sequence with 64 processors, for 10^6 elements,
                 // if there is one
  std::function<Many_search(std::size_t n)> make;
};

std::vector<Many_row> many_rows();

// Those without a target.
std::vector<Many_row> other_rows();

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_SEARCHES_H
