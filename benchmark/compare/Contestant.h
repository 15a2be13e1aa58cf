// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The methods that are compared, and how far. Each that calls our predicate has a file of its own:
// where few call it, compilers inline it, and its loops are up to twice as fast.

#ifndef THICK_INTERSECTION_BENCHMARK_COMPARE_CONTESTANT_H
#define THICK_INTERSECTION_BENCHMARK_COMPARE_CONTESTANT_H

#include "measuring/Tally.h"
#include "methods/Method.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace thick_benchmark {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Contestant : Method<Tally>
{
  bool is_exact;     // must find our pairs
  std::size_t max_n; // more points would take minutes
};

using Contestants = std::vector<Contestant>;

// search(points, r, tally), on points of EPICK.
template <class Search>
auto on_epick(const Search& search)
{
  return on_points<Tally, Epick>(search);
}

void add_ours(Contestants& all);
void add_recursive_route(Contestants& all);
void add_boxes(Contestants& all);
void add_delaunay(Contestants& all);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_COMPARE_CONTESTANT_H
