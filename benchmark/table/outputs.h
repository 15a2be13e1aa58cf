// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The table on the terminal, and as files that also tell the machine and the program.

#ifndef THICK_INTERSECTION_BENCHMARK_TABLE_OUTPUTS_H
#define THICK_INTERSECTION_BENCHMARK_TABLE_OUTPUTS_H

#include "rows.h"

#include <ostream>

namespace thick_benchmark {

void print_head(std::ostream& out);
void print_row(std::ostream& out, const Row& row);

void write_json(const std::string& file, const std::vector<Row>& rows);
void write_csv(const std::string& file, const std::vector<Row>& rows);
void write_markdown(const std::string& file, const std::vector<Row>& rows);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_TABLE_OUTPUTS_H
