// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The speed-up by two threads, beside that of two sorts, which have nothing to do with each other:
// how much of two processors the machine had to give at the time.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_SPEED_UP_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_SPEED_UP_H

#ifdef CGAL_LINKED_WITH_TBB

#include "timing.h"

#include <tbb/global_control.h>
#include <tbb/parallel_invoke.h>

#include <cstdint>

namespace thick_benchmark {

// While it lives, at most two threads take part in anything.
class Two_threads
{
  const tbb::global_control control_{tbb::global_control::max_allowed_parallelism, 2};
};

struct Speed_up
{
  double of_search;
  double of_machine;
  double milliseconds; // of two threads
};

inline void sort_numbers(std::uint64_t seed)
{
  std::vector<double> numbers(200000);
  for(double& x : numbers)
    x = static_cast<double>(seed = seed * 6364136223846793005 + 1442695040888963407);
  std::sort(numbers.begin(), numbers.end());
}

template <class Sequential, class Parallel>
Speed_up measure_speed_up(const Sequential& sequential, const Parallel& parallel)
{
  const auto first = [] { sort_numbers(1); };
  const auto second = [] { sort_numbers(2); };
  const std::vector<Seconds> times = time_in_turns(
    {timed_by_the_clock(sequential), timed_by_the_clock(parallel),
     timed_by_the_clock([&] { first(); second(); }),
     timed_by_the_clock([&] { tbb::parallel_invoke(first, second); })},
    7);
  return {median(times, [](const Seconds& s) { return s[0] / s[1]; }),
          median(times, [](const Seconds& s) { return s[2] / s[3]; }),
          median(times, [](const Seconds& s) { return 1000 * s[1]; })};
}

} // namespace thick_benchmark

#endif // CGAL_LINKED_WITH_TBB

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_SPEED_UP_H
