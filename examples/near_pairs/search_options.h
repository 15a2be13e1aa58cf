// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the search wants to know of the command line. The files that call the library include this
// and not options.h, because they take long to compile.

#ifndef NEAR_PAIRS_SEARCH_OPTIONS_H
#define NEAR_PAIRS_SEARCH_OPTIONS_H

#include "exact_number.h"

#include <cmath>

namespace near_pairs {

struct Search_options
{
  Exact_number distance; // exactly as typed: the distance, or its square if `squared`
  bool squared = false;
  bool open = false;
  bool overlap = false; // pairs of polygons that do, instead; there is no distance then
  bool parallel = false;
  bool progress = false;
};

// The distance, rounded.
inline double reach_of(const Search_options& options)
{
  const double distance = to_double(options.distance);
  return options.squared ? std::sqrt(distance) : distance;
}

} // namespace near_pairs

#endif // NEAR_PAIRS_SEARCH_OPTIONS_H
