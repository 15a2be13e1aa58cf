// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of points that move in the unit square or cube, for a day of minutes. A scene is the same
// in each run. About as many pairs are near as there are tracks, unless something else is said.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_TRACK_GENERATORS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_TRACK_GENERATORS_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Place_at_time
{
  double time; // minutes
  std::array<double, 3> place;
};

using Track = std::vector<Place_at_time>;

struct Track_scene
{
  std::string name;
  int dimension;
  std::vector<Track> tracks; // of two fixes or more
  double r;

  std::size_t leg_count() const;
};

// n tracks of one leg each, in any direction. They last for the same ten minutes, or for 5 to 25
// minutes of the day.
Track_scene short_legs(int dimension, std::size_t n, bool have_common_times);

// The same at their own times, but no point moves.
Track_scene standing(int dimension, std::size_t n);

// n legs from anywhere to anywhere, during the same hour.
Track_scene crossing_legs(int dimension, std::size_t n);

// A track of n fixes that wanders all day, and twice as many short legs in the plane.
Track_scene one_long_track(std::size_t n);

// Aircraft above Switzerland, from a file with a line for each aircraft and minute. The bound is
// five nautical miles, or a thousand feet of altitude. Few are so near.
Track_scene aircraft(const std::string& csv_file);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_TRACK_GENERATORS_H
