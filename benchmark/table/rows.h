// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The rows of a table: what is measured, and what it ought to be.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_ROWS_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_ROWS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace thick_benchmark {

// What a quantity has to reach, and what would be better still; some are only shown.
struct Goal
{
  enum Sense { AT_MOST, AT_LEAST };

  Sense sense = AT_MOST;
  std::optional<double> target;
  std::optional<double> good;
};

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

struct Settings
{
  bool is_quick = false;  // few points or objects
  bool huge = false;      // larger scenes as well
  std::string extra_data; // a folder, or empty
};

// An experiment gives a row or several. It throws if two methods disagree about the pairs.
struct Experiment
{
  std::string name;
  std::function<Rows()> run;
};

std::vector<Experiment> experiments(const Settings& settings);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_ROWS_H
