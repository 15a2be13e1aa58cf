// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the summaries of all searches have in common.

#ifndef NEAR_PAIRS_SUMMARY_H
#define NEAR_PAIRS_SUMMARY_H

#include "frame.h"
#include "options.h"

#include <ostream>
#include <string>
#include <vector>

namespace near_pairs {

// The most memory that this process ever had, in MiB.
double peak_memory();

// As it was typed; `unit` is that of the scene.
std::string distance_in_words(const Options& options, const std::string& unit);

// Prints the name of a line of the summary.
std::ostream& print_name(std::ostream& out, const char* name);

// Prints the columns of each file that were guessed by their names, if some were.
void print_guessed(std::ostream& out, const std::vector<std::string>& columns_of_files);

// Tells which frames of the files were read, if one of these has several.
void print_frames(std::ostream& out, const std::vector<Frame>& frames);

void print_kernel(std::ostream& out, const Options& options);
void print_costs(std::ostream& out, double seconds, const char* of_what);

} // namespace near_pairs

#endif // NEAR_PAIRS_SUMMARY_H
