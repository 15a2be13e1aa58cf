// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tracks on a lattice, and when two of them are closest: between two times at which one of them has
// a fix, the squared distance is a parabola through three of its values.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_TRACK_ORACLE_H
#define THICK_INTERSECTION_TEST_SUPPORT_TRACK_ORACLE_H

#include "pairs.h"

#include <CGAL/Exact_rational.h>

namespace test_support {

using CGAL::Exact_rational;

struct Lattice_fix
{
  int time;
  std::array<int, 3> place;
};
using Lattice_track = std::vector<Lattice_fix>;
using Lattice_tracks = std::vector<Lattice_track>;

struct Approach
{
  Exact_rational time;
  Exact_rational square;
};

inline std::array<Exact_rational, 3> place_at(const Lattice_track& track,
                                              const Exact_rational& time)
{
  std::size_t next = 0;
  while(Exact_rational(track[next].time) < time)
    ++next;
  std::array<Exact_rational, 3> place;
  for(std::size_t axis = 0; axis < 3; ++axis) {
    place[axis] = track[next].place[axis];
    if(next != 0) {
      const Lattice_fix& last = track[next - 1];
      const Exact_rational rest((track[next].time - time)
                                / Exact_rational(track[next].time - last.time));
      place[axis] += rest * Exact_rational(last.place[axis] - track[next].place[axis]);
    }
  }
  return place;
}

inline Exact_rational square_at(const Lattice_track& a, const Lattice_track& b,
                                const Exact_rational& time)
{
  const auto p = place_at(a, time), q = place_at(b, time);
  Exact_rational sum(0);
  for(std::size_t axis = 0; axis < 3; ++axis)
    sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
  return sum;
}

// The times at which two tracks exist and one has a fix.
inline std::vector<int> common_times(const Lattice_track& a, const Lattice_track& b)
{
  std::set<int> times;
  if(!a.empty() && !b.empty())
    for(const Lattice_track* track : {&a, &b})
      for(const Lattice_fix& fix : *track)
        if(fix.time >= (std::max)(a.front().time, b.front().time)
           && fix.time <= (std::min)(a.back().time, b.back().time))
          times.insert(fix.time);
  return {times.begin(), times.end()};
}

// Returns the first closest approach, or nothing.
inline std::optional<Approach> approach_of(const Lattice_track& a, const Lattice_track& b)
{
  std::optional<Approach> least;
  const auto look_at = [&](const Exact_rational& time) {
    const Exact_rational square = square_at(a, b, time);
    if(!least || square < least->square)
      least = {time, square};
  };
  const std::vector<int> times = common_times(a, b);
  for(std::size_t k = 0; k < times.size(); ++k) {
    const Exact_rational begin(times[k]);
    look_at(begin);
    if(k + 1 == times.size())
      break;
    const Exact_rational end(times[k + 1]), middle((begin + end) / 2);
    const Exact_rational f = square_at(a, b, begin), g = square_at(a, b, middle),
                         h = square_at(a, b, end);
    const Exact_rational bend(2 * (f + h - 2 * g)), slope(h - f - bend);
    if(bend > 0 && slope < 0 && slope > -2 * bend)
      look_at(Exact_rational(begin - (end - begin) * slope / (2 * bend)));
  }
  return least;
}

inline bool are_tracks_near(const Lattice_track& a, const Lattice_track& b, int r2, bool is_open)
{
  const std::optional<Approach> approach = approach_of(a, b);
  return approach && (is_open ? approach->square < r2 : approach->square <= r2);
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_TRACK_ORACLE_H
