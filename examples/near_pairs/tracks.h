// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The tracks of the input: points that move straight from fix to fix.

#ifndef NEAR_PAIRS_TRACKS_H
#define NEAR_PAIRS_TRACKS_H

#include "options.h"
#include "scene.h"
#include "time_text.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace near_pairs {

struct Fix
{
  std::int64_t tick;
  std::size_t point; // in the scene
  std::size_t line;  // in its file
};

// Fixes by their times, which differ. A track is there from the first one to the last one of a
// piece.
using Piece = std::vector<Fix>;

struct Track
{
  std::string id;
  std::vector<Piece> pieces;
};

struct Tracks
{
  Scene scene;
  std::vector<Track> tracks;
  std::size_t first_size; // tracks of the first file
  std::size_t fixes = 0;  // rows of the files that tell one

  // Ticks are steps of 10^-scale seconds, from the earliest fix on. With --velocity there are two,
  // 0 and 1, at the beginning and the end of the look ahead.
  int scale = 0;
  std::int64_t first_tick = 0; // since the time 0 of the form
  Time_form form;

  bool are_looked_ahead = false; // with --velocity
  double look_ahead = 0;         // in seconds, then
  std::size_t standing = 0;      // rows without a speed or a course, then

  // Of a track in its file: with --velocity, that of its row.
  std::size_t position(std::size_t track) const;

  // The coordinates of a track at a time, rounded. A piece of it must be there.
  std::array<double, 3> place_at(std::size_t track, double tick) const;

  // The text of a time, which is so much of a tick behind one.
  std::string time_text(std::int64_t tick, double part) const;

  // The length of the longest leg, rounded.
  double longest_leg() const;
};

// Whether rows are places of tracks, or points with a velocity.
bool have_tracks(const Options& options);

// Throws Error, with file and line, if anything in the file cannot be taken at its word.
Tracks read_tracks(const Options& options);

} // namespace near_pairs

#endif // NEAR_PAIRS_TRACKS_H
