// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The numbers that the texts of a row mean.

#ifndef NEAR_PAIRS_ROW_NUMBERS_H
#define NEAR_PAIRS_ROW_NUMBERS_H

#include "decimal.h"
#include "input.h"
#include "row_reader.h"

#include <array>

namespace near_pairs {

// The row in hand, and where it comes from.
struct Place
{
  const Input& input;
  const Row_reader& reader;
  const Row& row;
};

// Whether the text of a number says that there is none: it is empty, NA, NaN, null, - or the like.
bool is_missing(const std::string& text);

// Whether the text is a number with a comma in the place of the decimal point.
bool has_decimal_comma(const std::string& text);

// A coordinate of a row, as it is written and as the nearest double, which is finite.
struct Number
{
  Decimal decimal;
  double value;
};

// Throws Error if the text is no finite number, or if it is no degree where degrees are to be.
Number read_number(const Place& place, int axis);

// The place in space that latitude, longitude and perhaps altitude name. Longitudes that differ by
// 360 degrees name one place, and so do all at a pole. Throws Error if they are none.
std::array<double, 3> place_on_sphere(const Place& place);

} // namespace near_pairs

#endif // NEAR_PAIRS_ROW_NUMBERS_H
