// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rows of tables of the distributed search. All processes call these functions together.

#ifndef THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_TABLES_H
#define THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_TABLES_H

#include "measuring/Tally.h"
#include "scenes/Scene.h"

#include <cstddef>

namespace thick_benchmark {

// Two processes beside two threads of one process.
void print_threads(bool is_quick);

// Ours beside the tree of ArborX.
void print_trees(bool is_quick);

// The peak of memory, to be measured once in a process.
void print_memory(bool is_quick);

// Returns the pairs that the distributed tree of ArborX reports on this process: of each point in
// `share`, whose first position is given, those behind it. Has points and distances in doubles.
Tally search_distributed_tree(const Scene& share, std::size_t first);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_DISTRIBUTED_TABLES_H
