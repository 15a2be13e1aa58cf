// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The options for points that move, and for heights.

#ifndef NEAR_PAIRS_TRACK_OPTIONS_H
#define NEAR_PAIRS_TRACK_OPTIONS_H

#include "command_line.h"
#include "options.h"

#include <cstddef>

namespace near_pairs {

void add_track_options(po::options_description& all);

// Read what is asked, and what the reader of file `file` is told. They throw Error if options are
// wrong, or do not go together.
void read_track_options(const po::variables_map& map, Options& options);
void read_track_reading(const po::variables_map& map, std::size_t file, Read_options& reading);

} // namespace near_pairs

#endif // NEAR_PAIRS_TRACK_OPTIONS_H
