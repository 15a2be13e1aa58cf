// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of the library, ready to be run on a scene as often as wanted. Each kernel is
// compiled in a file of its own.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_OURS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_OURS_H

#include "Method.h"

#include "measuring/Tally.h"

#include <cstdint>

namespace thick_benchmark {

// They share the points of the scene in some kernel.
struct Search
{
  Run<Tally> sequential;
  Run<Tally> parallel; // empty without oneTBB
  Run<Tally> sequential_like_parallel; // with the callback of `parallel`, which takes longer
  Run<std::uint64_t> lists; // makes lists of neighbours, returns the number of pairs
  Run<double> sum_of_intervals; // one pass of to_interval() over all coordinates
};

Search search_double(const Scene& scene); // Simple_cartesian<double>
Search search_epick(const Scene& scene);
Search search_epeck(const Scene& scene);
Search search_exact(const Scene& scene); // Simple_cartesian<Exact_rational>

// The pairs by the recursive route, whose code shares nothing with the default search but the exact
// predicate.
Tally tally_by_recursive_route(const Scene& scene);

// All pairs, as one would write them down: doubles and two loops.
Run<Tally> naive_double_loop(const Scene& scene);

// The number of pairs, or a larger number than `limit` if there are more.
std::uint64_t count_pairs(const Scene& scene, std::uint64_t limit);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_OURS_H
