// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CLOSEST_APPROACH_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CLOSEST_APPROACH_SEARCH_H

// The search behind closest_approach(): the legs of both tracks that have a time in common, in the
// order of time.

#include <CGAL/Exact_rational.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Relative_motion.h>
#include <CGAL/Thick_intersection_d/internal/tracks/Track_legs.h>
#include <CGAL/Thick_intersection_d/internal/tracks/check_tracks.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Finds the least distance in doubles first. Then only those legs are asked in exact numbers that
// may have it.
template <class Fix>
class Approach_search
{
  using Legs = Track_legs<Fix>;
  using Motion = Relative_motion<Exact_rational, std::size_t(Legs::dimension)>;

public:
  template <class First, class Second>
  Approach_search(const First& first, const Second& second)
  {
    check_denormals();
    legs_.add_track(first);
    second_ = legs_.size();
    legs_.add_track(second);
  }

  // Sets the time and the square of the least distance, the first one if there are several. Returns
  // false if the tracks have no time in common.
  bool find(Exact_rational& time, Exact_rational& squared_distance) const
  {
    double least = std::numeric_limits<double>::infinity();
    for_common_times([&](std::size_t i, std::size_t j) {
      least = (std::min)(least, distance(i, j).high);
    });
    bool is_found = false;
    for_common_times([&](std::size_t i, std::size_t j) {
      if(distance(i, j).low <= least)
        is_found |= find_between(i, j, !is_found, time, squared_distance);
    });
    return is_found;
  }

private:
  // Calls task(i, j) for the legs that have a time in common, and a few others. Of two legs, the
  // one that ends first has no time in common with those that come next.
  template <class Task>
  void for_common_times(const Task& task) const
  {
    std::size_t i = 0, j = second_;
    while(i < second_ && j < legs_.size()) {
      task(i, j);
      const int order = legs_.compare_ends(i, j);
      i += order <= 0;
      j += order >= 0;
    }
  }

  Interval distance(std::size_t i, std::size_t j) const
  {
    return Relative_segment<std::size_t(Legs::dimension)>(legs_.leg(i), legs_.leg(j)).distance();
  }

  // Sets both if the legs come closer than before, or if nothing is known yet.
  bool find_between(std::size_t i, std::size_t j, bool is_first, Exact_rational& time,
                    Exact_rational& squared_distance) const
  {
    const Motion motion(legs_.template exact_leg<Exact_rational>(i),
                        legs_.template exact_leg<Exact_rational>(j));
    if(!motion.has_time())
      return false;
    motion.with_least([&](const Exact_rational& t, const Exact_rational& n,
                          const Exact_rational& d) {
      const Exact_rational square(n / d);
      if(is_first || square < squared_distance) {
        time = t;
        squared_distance = square;
      }
    });
    return true;
  }

  Legs legs_;
  std::size_t second_;
};

template <class TrackA, class TrackB>
bool find_closest_approach(const TrackA& a, const TrackB& b, Exact_rational& time,
                           Exact_rational& squared_distance)
{
  if constexpr(check_track_types<TrackA, TrackB>())
    return Approach_search<Fix_of_t<TrackA>>(a, b).find(time, squared_distance);
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CLOSEST_APPROACH_SEARCH_H
