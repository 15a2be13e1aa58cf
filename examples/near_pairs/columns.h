// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Which columns of a table have the coordinates, as far as their names tell.

#ifndef NEAR_PAIRS_COLUMNS_H
#define NEAR_PAIRS_COLUMNS_H

#include <cstddef>
#include <string>
#include <vector>

namespace near_pairs {

struct Column_guess
{
  std::vector<std::size_t> columns; // none if the names do not tell
  bool are_degrees = false;
  std::vector<std::size_t> rivals;  // if several columns may have the same coordinate
};

// Names of one word come first, such as x, y and z, easting and northing, lat and lon, or
// decimalLatitude and decimalLongitude; then names of more words, if all but one of them are the
// same: coord_x and coord_y, start_lat and start_lon. Columns are in the order of the plane, x or
// longitude first, or latitude first if that is wanted; then x and y are not looked for. The
// dimension is 2 or 3, or 0 for all coordinates that there are.
Column_guess guess_columns(const std::vector<std::string>& names, bool latitude_first,
                           int dimension);

bool is_latitude(const std::string& name);  // or y
bool is_longitude(const std::string& name); // or x

} // namespace near_pairs

#endif // NEAR_PAIRS_COLUMNS_H
