// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the user asked for on the command line, checked as far as that is possible without looking
// at the file.

#ifndef NEAR_PAIRS_OPTIONS_H
#define NEAR_PAIRS_OPTIONS_H

#include "cell.h"
#include "read_options.h"
#include "search_options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace near_pairs {

struct Options : Search_options, Read_options
{
  std::vector<std::string> files; // "-" is the standard input

  // What the reader of each file is told: --id and --columns may be given for each.
  std::vector<Read_options> readings;

  std::string distance_text; // as typed, without its unit
  std::string distance_unit; // as typed; empty: that of the scene
  bool closest = false;      // the closest pair instead; there is no distance then

  Exact_number until;                  // seconds, with --velocity
  std::string until_text;              // as typed
  std::optional<Exact_number> max_gap; // seconds, of tracks

  bool is_periodic = false;
  std::optional<Cell> cell; // if it is periodic; none: the file tells it

  std::string kernel = "epick";
  std::size_t memory = 0; // in bytes; 0: as much as the points take
  std::string scratch;    // the folder for what does not fit; empty: that of the system

  // Names of files, "-" for the standard output, or empty.
  std::string pairs;
  std::string points;
  std::string picture;
  bool coordinates = false; // in the tables
  bool components = false;  // counted, and in the picture
  bool explain = false;
  bool help = false;
  bool help_tracks = false;
  bool version = false;
};

// Throws Error if the command line cannot be used. With --help, --help-tracks or --version, nothing
// else is checked.
Options parse_options(int argc, const char* const* argv);

std::string help_text();
std::string track_help_text(); // of the options for points that move
std::string version_text();

} // namespace near_pairs

#endif // NEAR_PAIRS_OPTIONS_H
