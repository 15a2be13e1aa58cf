// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_PAIRS_SEARCH_H

// The search behind fixed_radius_near_tracks(): the legs of all tracks take the box route, in space
// and time.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/tracks/Are_tracks_near.h>
#include <CGAL/Thick_intersection_d/internal/tracks/Track_legs.h>
#include <CGAL/Thick_intersection_d/internal/tracks/check_tracks.h>
#include <CGAL/Thick_intersection_d/internal/tracks/cut_legs.h>
#include <CGAL/Thick_intersection_d/internal/tracks/scan_legs.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Range>
using Track_of = typename std::decay_t<Range>::value_type;

template <class Elements, class NamedParameters>
constexpr bool check_track_search()
{
  using A = Track_of<decltype(std::declval<const Elements&>().first())>;
  using B = Track_of<decltype(std::declval<const Elements&>().second())>;
  if constexpr(check_tracks<A, B>())
    return check_no_traits<typename Fix_of_t<A>::second_type, NamedParameters>();
  else
    return false;
}

// Reports the near pairs of tracks. Returns false iff the search was stopped. Takes the tier that
// is forced in `profile`, and sets `profile` to that of the scene, unless it is null.
template <class Elements, class Sets, class NT, class Report, class NamedParameters>
bool report_near_tracks(const Elements& elements, const Sets& sets,
                        const Distance_bound<NT>& bound, Report& report, Scene_profile* profile,
                        const NamedParameters& np, const Threads& threads)
{
  using Legs = Track_legs<Fix_of_t<Track_of<decltype(elements.first())>>>;
  check_denormals();
  Legs legs;
  legs.add_tracks(elements);
  const double reach = Squared_bound<typename Legs::Exact>(bound).reach();
  const auto search = [&](Arithmetic_tier least_tier, Shared_decision_counts* counts) {
    cut_legs(legs, reach);
    const Are_tracks_near<Legs> boxes(legs, bound, least_tier, counts, threads);
    const std::size_t second = legs.first_stretch_from(sets.first_of_second());
    auto progress = make_progress(np, legs.size());
    return report_meeting_groups(boxes, sets, second, report, progress, threads);
  };
  if(profile == nullptr)
    return search(Arithmetic_tier::INT64, nullptr);
  const Object_scene scene = scan_legs(legs, bounds(bound.value()), reach);
  return search_profiled(*profile, {scene, legs.have_common_times() ? 4 : 10}, search);
}

// Returns search(elements, sets, report) for the near pairs of tracks.
template <class NT, class NamedParameters>
auto track_search(const Distance_bound<NT>& bound, Scene_profile* profile,
                  const NamedParameters& np, const Threads& threads)
{
  return [&bound, profile, &np, &threads](const auto& elements, const auto& sets, auto& report) {
    if constexpr(check_track_search<std::decay_t<decltype(elements)>, NamedParameters>())
      return report_near_tracks(elements, sets, bound, report, profile, np, threads);
    else
      return false;
  };
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_PAIRS_SEARCH_H
