// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search with --memory: of a file of more points than the memory holds.

#ifndef NEAR_PAIRS_EXTERNAL_H
#define NEAR_PAIRS_EXTERNAL_H

#include "frame.h"
#include "options.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace near_pairs {

struct External_result
{
  std::uint64_t points = 0;
  std::uint64_t pairs = 0;
  std::string unit;    // of the distance
  std::string guessed; // the columns of a table, if names told them
  Frame frame;
  double seconds = 0; // from reading the file to the last pair
};

// Receives each pair once, i < j, as positions in the file. It is never called by two threads at
// once.
using External_sink = std::function<void(std::uint64_t i, std::uint64_t j)>;

// Takes `bytes` of memory, besides what the program has already. search_external.cpp calls the
// library, and takes long to compile.
External_result search_external(const Options& options, std::size_t bytes,
                                const External_sink& sink);

// Searches, writes the pairs if they are wanted, and prints the summary.
void run_external(const Options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_EXTERNAL_H
