// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the readers of files want to know of the command line.

#ifndef NEAR_PAIRS_READ_OPTIONS_H
#define NEAR_PAIRS_READ_OPTIONS_H

#include <cstddef>
#include <string>
#include <vector>

namespace near_pairs {

struct Read_options
{
  int dimension = 0; // 0: what the file has
  bool solids = false; // meshes, whose faces are wanted
  bool geographic = false;
  std::string format;             // the extension it goes by; empty: that of the file
  char separator = 0;             // of a table; 0: to be found, ' ': any number of blanks and tabs
  bool no_header = false;
  bool comma_numbers = false;     // decimals have a comma where others have a point
  bool skip_missing = false;      // leave out rows without a coordinate
  bool may_skip_missing = false;  // whether the command line may ask for it
  std::vector<std::string> columns;
  std::string id;                 // the column of names; empty: the one that is called so
  bool decimal = false;
  std::size_t frame = 1;          // which one is read, if the file may have several
  std::string altitude;           // the column of heights above the sphere, or empty
  double altitude_unit = 1;       // in meters
  std::string time;               // the column of times, if rows are places of tracks
  std::vector<std::string> velocity; // the columns of speed, course and perhaps climb, or none

  // Forgets what is for tables only.
  void take_no_table()
  {
    separator = 0;
    no_header = comma_numbers = false;
    columns.clear();
    id.clear();
    altitude.clear();
  }
};

} // namespace near_pairs

#endif // NEAR_PAIRS_READ_OPTIONS_H
