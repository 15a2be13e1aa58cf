// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A program for each table: main.cpp, and the file that has its print_table().

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_TABLE_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_TABLE_H

#include <string>

namespace thick_benchmark {

// The options, which main.cpp explains.
struct Settings
{
  bool is_quick = false;
  bool is_large = false;
  bool is_chart = false;
  bool has_postgis = false;
  std::string only;
  std::string data;
};

// Prints the table in Markdown, or what a chart is drawn from. Throws if two methods disagree.
void print_table(const Settings& settings);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_TABLE_H
