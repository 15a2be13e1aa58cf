// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs of points that move, with the time and the distance of their closest approach.

#ifndef NEAR_PAIRS_TRACK_PAIRS_H
#define NEAR_PAIRS_TRACK_PAIRS_H

#include "options.h"

namespace near_pairs {

// Reads, searches, writes the pairs and the picture if they are wanted, and prints the summary.
void run_tracks(const Options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_TRACK_PAIRS_H
