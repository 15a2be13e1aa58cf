// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_PAIRS_SEARCH_H

// The search behind fixed_radius_near_tracks(): the legs of all tracks take the box route, in space
// and time.

#include <CGAL/Arithmetic_tier.h>
#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/lists/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/reports/Pair_output.h>
#include <CGAL/Thick_intersection_d/internal/reports/Progress.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/tracks/Are_tracks_near.h>
#include <CGAL/Thick_intersection_d/internal/tracks/Track_legs.h>
#include <CGAL/Thick_intersection_d/internal/tracks/check_tracks.h>
#include <CGAL/Thick_intersection_d/internal/tracks/cut_legs.h>
#include <CGAL/Thick_intersection_d/internal/tracks/scan_legs.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The tracks of one range, which is both sets, or of two.
template <class First, class... Second>
class Track_search
{
  using Legs = Track_legs<Fix_of_t<typename First::value_type>>;
  using Sets = std::conditional_t<sizeof...(Second) == 0, One_set, Two_sets>;

public:
  Track_search(const Threads& threads, const First& first, const Second&... second)
    : threads_(threads)
  {
    check_denormals();
    legs_.add_tracks(first);
    if constexpr(Sets::are_two) {
      second_track_ = legs_.track_count();
      second_leg_ = legs_.size();
      legs_.add_tracks(second...);
    }
  }

  // Reports the pairs of tracks. Returns false iff the search was stopped.
  template <class NT, class Report, class NamedParameters>
  bool report(const Distance_bound<NT>& bound, Report& report, const NamedParameters& np)
  {
    return report_pairs(bound, Arithmetic_tier::INT64, nullptr, report, np);
  }

  // The same, with the tier that is forced in `profile`. Sets `profile` to that of the scene.
  template <class NT, class Report, class NamedParameters>
  bool report(const Distance_bound<NT>& bound, Report& report, Scene_profile& profile,
              const NamedParameters& np)
  {
    const double reach = Squared_bound<typename Legs::Exact>(bound).reach();
    Scene_profile found(scan_legs(legs_, bounds(bound.value()), reach), degree_of_legs(legs_));
    if(const std::optional<Arithmetic_tier> forced = profile.forced_tier())
      found.force_tier(*forced);
    Shared_decision_counts counts;
    const bool is_complete = report_pairs(
      bound, found.forced_tier().value_or(Arithmetic_tier::INT64), &counts, report, np);
    found.set_counts(counts.total());
    profile = found;
    return is_complete;
  }

  // Replaces `lists` by those of the near tracks of each track.
  template <class NT, class NamedParameters>
  bool collect(Neighbor_lists& lists, const Distance_bound<NT>& bound, const NamedParameters& np)
  {
    const auto search = [&](auto& callback) { return report(bound, callback, np); };
    return collect_pairs(lists, legs_.track_count(), make_sets(second_track_), search, threads_);
  }

private:
  static Sets make_sets([[maybe_unused]] std::size_t first_size)
  {
    Sets sets = {};
    if constexpr(Sets::are_two)
      sets.first_size = first_size;
    return sets;
  }

  template <class NT, class Report, class NamedParameters>
  bool report_pairs(const Distance_bound<NT>& bound, Arithmetic_tier least_tier,
                    Shared_decision_counts* counts, Report& report, const NamedParameters& np)
  {
    const Are_tracks_near<Legs> boxes(legs_, bound, least_tier, counts, threads_);
    cut_legs(legs_, boxes, second_leg_);
    auto progress = make_progress(np, legs_.size());
    const auto take = [&](std::size_t i, std::size_t j) {
      const std::size_t a = legs_.track_of(i), b = legs_.track_of(second_leg_ + j);
      return report((std::min)(a, b), (std::max)(a, b) - second_track_);
    };
    return report_meeting_boxes(boxes, make_sets(second_leg_), take, progress, threads_);
  }

  const Threads threads_;
  Legs legs_;
  std::size_t second_track_ = 0; // where the second range begins
  std::size_t second_leg_ = 0;
};

// Reports the near pairs of tracks of one range, or of two. `profile` is a Scene_profile, or left
// out. Returns false iff the search was stopped.
template <class NT, class Callback, class NamedParameters, class... Ranges, class... Profile>
bool search_tracks(const std::tuple<Ranges&...>& ranges, const Distance_bound<NT>& bound,
                   Callback& callback, const NamedParameters& np, const Threads& threads,
                   Profile&... profile)
{
  if constexpr(check_track_search<Callback, NamedParameters, Ranges...>()) {
    const auto search = [&](const auto&... elements) {
      const auto both = std::tie(elements...);
      auto&& report = pair_output(std::get<0>(both), std::get<sizeof...(Ranges) - 1>(both),
                                  callback, threads);
      return Track_search<std::decay_t<decltype(elements)>...>(threads, elements...)
        .report(bound, report, profile..., np);
    };
    return std::apply([&](auto&... range) { return search(make_elements(range, np)...); }, ranges);
  }
  else
    return false;
}

// Replaces `lists` by those of the near tracks of each track.
template <class NT, class NamedParameters, class... Ranges>
bool collect_tracks(Neighbor_lists& lists, const std::tuple<Ranges&...>& ranges,
                    const Distance_bound<NT>& bound, const NamedParameters& np,
                    const Threads& threads)
{
  if constexpr(check_tracks<NamedParameters, Ranges...>()) {
    const auto collect = [&](const auto&... elements) {
      return Track_search<std::decay_t<decltype(elements)>...>(threads, elements...)
        .collect(lists, bound, np);
    };
    return std::apply([&](auto&... range) { return collect(make_elements(range, np)...); }, ranges);
  }
  else
    return false;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_PAIRS_SEARCH_H
