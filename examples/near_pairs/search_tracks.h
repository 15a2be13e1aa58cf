// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of tracks, which takes long to compile.

#ifndef NEAR_PAIRS_SEARCH_TRACKS_H
#define NEAR_PAIRS_SEARCH_TRACKS_H

#include "options.h"
#include "tracks.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace near_pairs {

// When two tracks are closest, the first time if there are several, and how close. The part and the
// distance are rounded.
struct Approach
{
  std::size_t i, j;  // among the tracks of all files
  std::int64_t tick; // the last one that is not behind the time
  double part;       // of the next one
  double distance;

  double rounded_tick() const { return static_cast<double>(tick) + part; }
};

struct Track_result
{
  std::vector<Approach> pairs; // by i and j, which are i < j
  std::size_t on_boundary = 0; // pairs exactly at the distance, if the bound is closed
  bool has_moved_ties = false; // pairs are beyond the bound, or within an open one, and rounding
                               // may be the reason
  std::string tier;            // the arithmetic that the tracks needed
};

// Searches the tracks of one file, or those of the first against those of the second. Throws Error
// if the search is stopped, or if times do not fit into the numbers of the kernel.
Track_result search_tracks(const Tracks& tracks, const Options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_SEARCH_TRACKS_H
