// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of points that move, ours and what else there is. Each makes its own tracks ahead,
// and begins with them.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_TRACK_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_TRACK_METHODS_H

#include "Method.h"

#include "measuring/Tally.h"
#include "scenes/track_generators.h"

namespace thick_benchmark {

using Track_method = Method<Pair_list, Track_scene>; // of tracks; i < j

Track_method tracks_ours(); // fixed_radius_near_tracks

// The pairs of boxes of legs, in space and time, each grown by half of the bound:
// thick_box_self_intersection_d.
Method<Tally, Track_scene> boxes_of_legs();

// Compares each leg with those that begin before it ends, in time or along the first axis: the one
// of them along which legs are shorter. Distances are computed in doubles.
Track_method tracks_by_sweep();

// The near points of each minute.
Track_method tracks_by_minutes();

// PostGIS, in one thread: an index of n dimensions finds legs whose boxes are near, and
// ST_CPAWithin compares these. psql finds the server by the variables of its environment.
struct Timed_pairs
{
  Pair_list found;
  double seconds; // of the processor, of the query alone
};
Timed_pairs tracks_by_postgis(const Track_scene& scene);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_TRACK_METHODS_H
