// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of the library, ready to be run on a scene as often as wanted. Each kernel is
// compiled in a file of its own.

#ifndef THICK_INTERSECTION_BENCHMARK_SUPPORT_SEARCH_H
#define THICK_INTERSECTION_BENCHMARK_SUPPORT_SEARCH_H

#include "Scene.h"
#include "Tally.h"

#include <cstdint>
#include <functional>

namespace thick_benchmark {

using Run = std::function<Tally()>;

// They share the points of the scene in some kernel.
struct Search
{
  Run sequential;
  Run parallel; // empty without oneTBB
  Run sequential_like_parallel; // with the callback of `parallel`, which takes longer to call
  std::function<std::uint64_t()> lists; // makes lists of neighbours, returns the number of pairs
  std::function<double()> sum_of_intervals; // one pass of to_interval() over all coordinates
};

Search search_double(const Scene& scene); // Simple_cartesian<double>
Search search_epick(const Scene& scene);
Search search_epeck(const Scene& scene);
Search search_exact(const Scene& scene); // Simple_cartesian<Exact_rational>

// The pairs by [V03] as written, whose code shares nothing with the default search but the exact
// predicate.
Tally tally_by_the_book(const Scene& scene);

// All pairs, as one would write them down: doubles and two loops.
Run naive_double_loop(const Scene& scene);

// The number of pairs, or a larger number than `limit` if there are more.
std::uint64_t count_pairs(const Scene& scene, std::uint64_t limit);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SUPPORT_SEARCH_H
