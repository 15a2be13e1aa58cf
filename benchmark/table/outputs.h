// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The table on the terminal, and as files that also tell the machine and the program.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_OUTPUTS_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_OUTPUTS_H

#include "rows.h"

#include <ostream>

namespace thick_benchmark {

// How many decimals of a figure are shown: three digits in all, the others are noise.
int decimals(double value);

// "good", "met" or "missed", by the figure that is shown; empty for quantities without a target.
std::string verdict(const Row& row);

void print_head(std::ostream& out);
void print_row(std::ostream& out, const Row& row);

void write_json(const std::string& file, const Rows& rows);
void write_csv(const std::string& file, const Rows& rows);
void write_markdown(const std::string& file, const Rows& rows);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_OUTPUTS_H
