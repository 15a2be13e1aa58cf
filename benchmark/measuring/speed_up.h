// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The speed-up by two threads, beside that of two searches in sequence at the same time, which have
// nothing to do with each other: how much of two processors the machine had to give.

#ifndef THICK_INTERSECTION_BENCHMARK_MEASURING_SPEED_UP_H
#define THICK_INTERSECTION_BENCHMARK_MEASURING_SPEED_UP_H

#ifdef CGAL_LINKED_WITH_TBB

#include "timing.h"

#include <tbb/global_control.h>
#include <tbb/parallel_invoke.h>

#include <vector>

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
  double share; // of what the machine had to give, in the same round
  double milliseconds; // of two threads
};

// `alone` is a search in sequence that shares nothing with another one. The machine's speed-up is
// that of two of them at the same time: a sort of few numbers would stay in a cache of its own.
template <class Sequential, class Parallel, class Alone>
Speed_up measure_speed_up(const Sequential& sequential, const Parallel& parallel,
                          const Alone& alone)
{
  const std::vector<Seconds> times = time_in_turns(
    {timed_by_the_clock(sequential), timed_by_the_clock(parallel), timed_by_the_clock(alone),
     timed_by_the_clock([&] { tbb::parallel_invoke(alone, alone); })},
    9);
  const auto of_search = [](const Seconds& s) { return s[0] / s[1]; };
  const auto of_machine = [](const Seconds& s) { return 2 * s[2] / s[3]; };
  return {median(times, of_search), median(times, of_machine),
          median(times, [&](const Seconds& s) { return of_search(s) / of_machine(s); }),
          median(times, [](const Seconds& s) { return 1000 * s[1]; })};
}

} // namespace thick_benchmark

#endif // CGAL_LINKED_WITH_TBB

#endif // THICK_INTERSECTION_BENCHMARK_MEASURING_SPEED_UP_H
