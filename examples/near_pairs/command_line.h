// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the files that read the command line have in common.

#ifndef NEAR_PAIRS_COMMAND_LINE_H
#define NEAR_PAIRS_COMMAND_LINE_H

#include <boost/program_options.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace near_pairs {

namespace po = boost::program_options;

using Texts = std::vector<std::string>; // of an option that may be given for each file

// Each description has one line, so that a help has one screen.
constexpr unsigned columns_of_help = 80, columns_of_descriptions = 54;

// Options under a title.
po::options_description group(const char* title);

// The text of an option for file `file`: that of all files if it was given once. An empty text
// stands for the default.
std::string text_for_file(const po::variables_map& map, const std::string& option,
                          std::size_t file);

// Whether an option was given, but for no file: as by a variable of a shell that is not set.
bool are_all_empty(const Texts& texts);

// What is between commas, before the first and behind the last one; nothing of an empty text.
Texts split_at_commas(const std::string& text);

} // namespace near_pairs

#endif // NEAR_PAIRS_COMMAND_LINE_H
