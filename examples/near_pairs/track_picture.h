// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The drawing of tracks as SVG, seen from above: lines, and a mark and a short line at each closest
// approach.

#ifndef NEAR_PAIRS_TRACK_PICTURE_H
#define NEAR_PAIRS_TRACK_PICTURE_H

#include "options.h"
#include "search_tracks.h"
#include "tracks.h"

#include <ostream>
#include <vector>

namespace near_pairs {

void draw_tracks(std::ostream& svg, const Tracks& tracks, const std::vector<Approach>& pairs,
                 const Options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_TRACK_PICTURE_H
