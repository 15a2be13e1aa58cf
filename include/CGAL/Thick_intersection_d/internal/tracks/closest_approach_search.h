// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CLOSEST_APPROACH_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CLOSEST_APPROACH_SEARCH_H

// The search behind closest_approach(): the legs of both tracks that have a time in common, in the
// order of time.

#include <CGAL/Exact_rational.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Relative_motion.h>
#include <CGAL/Thick_intersection_d/internal/tracks/Track_legs.h>
#include <CGAL/Thick_intersection_d/internal/tracks/check_tracks.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Calls task(i, j) for the legs of two tracks that have a time in common, and a few others. The
// legs of the second track begin at `second`. Of two legs, the one that ends first has at most this
// time in common with those that come next.
template <class Legs, class Task>
void for_common_times(const Legs& legs, std::size_t second, const Task& task)
{
  std::size_t i = 0, j = second;
  while(i < second && j < legs.size()) {
    task(i, j);
    ++(legs.ends_before(i, j) ? i : j);
  }
}

// Returns the time and the square of the least distance of two tracks, the first one if there are
// several, or nothing if they have no time in common. Finds the distance in doubles first. Then
// only those legs are asked in exact numbers that may have it.
template <class Approach, class TrackA, class TrackB>
std::optional<Approach> find_closest_approach(const TrackA& a, const TrackB& b)
{
  std::optional<Approach> closest;
  if constexpr(check_tracks<TrackA, TrackB>()) {
    check_denormals();
    Track_legs<Fix_of_t<TrackA>> legs;
    legs.add_track(a);
    const std::size_t second = legs.size();
    legs.add_track(b);
    const auto distance = [&](std::size_t i, std::size_t j) {
      return distance_of(legs.leg(i), legs.leg(j));
    };
    double least = std::numeric_limits<double>::infinity();
    for_common_times(legs, second, [&](std::size_t i, std::size_t j) {
      least = (std::min)(least, distance(i, j).high);
    });
    for_common_times(legs, second, [&](std::size_t i, std::size_t j) {
      if(distance(i, j).low > least)
        return;
      const Relative_motion motion(legs.template exact_leg<Exact_rational>(i),
                                   legs.template exact_leg<Exact_rational>(j));
      if(!motion.has_time())
        return;
      const auto [n, d] = motion.least_square();
      const Exact_rational square(n / d);
      if(!closest || square < closest->squared_distance)
        closest = Approach{motion.time_of_least(), square};
    });
  }
  return closest;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CLOSEST_APPROACH_SEARCH_H
