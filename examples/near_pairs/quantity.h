// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Lengths and times as people type them: a number, and perhaps a unit behind it, as 500m or 12 min.

#ifndef NEAR_PAIRS_QUANTITY_H
#define NEAR_PAIRS_QUANTITY_H

#include "exact_number.h"

#include <optional>
#include <string>

namespace near_pairs {

struct Quantity
{
  Exact_number value; // of the number as it is typed
  std::string number; // its text
  std::string unit;   // the letters behind it, or empty
};

// Returns nothing if the text does not begin with a number.
std::optional<Quantity> parse_quantity(const std::string& text);

// The meters in m, km, nmi, mi or ft, and the seconds in s, min or h. Nothing is in any other unit.
std::optional<Exact_number> meters_in(const std::string& unit);
std::optional<Exact_number> seconds_in(const std::string& unit);

} // namespace near_pairs

#endif // NEAR_PAIRS_QUANTITY_H
