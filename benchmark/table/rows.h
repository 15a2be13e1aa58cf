// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The rows of a table of promises: what is measured, and what it ought to be; and the subjects that
// rows are made of, searches whose pairs have been checked.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_ROWS_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_ROWS_H

#include "goal.h"
#include "table.h"

#include "measuring/timing.h"
#include "methods/ours.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Row
{
  std::string name;
  std::string quantity;
  Goal goal;
  double measured;
  std::size_t n;
  std::uint64_t k;
  std::optional<double> milliseconds; // of the search that the row is about
  // Of a job that is as parallel as can be, in the same minute; of rows in parallel only.
  std::optional<double> machine_speed_up = std::nullopt;
};

using Rows = std::vector<Row>;

// An experiment gives a row or several. It throws if two methods disagree about the pairs.
struct Experiment
{
  std::string name;
  std::function<Rows()> run;
};

using Experiments = std::vector<Experiment>;

// Runs those that the settings want, and prints their rows.
void print_rows(const Experiments& experiments, const Settings& settings);

// ---- subjects -----------------------------------------------------------------------------------

inline double milliseconds_of_first(const Seconds& s) { return 1000 * s[0]; }

struct Subject
{
  std::string name;
  std::size_t n;
  std::uint64_t k;
  Search search;
};

// After all ways of the search have found the same pairs.
Subject make_subject(const std::string& name, std::size_t n, const Search& search,
                     const Tally& expected);

#ifdef CGAL_LINKED_WITH_TBB
// With the same callback on both sides.
Row measure_two_threads(const Subject& subject);
#endif

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_ROWS_H
