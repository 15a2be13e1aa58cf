// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for pairs of tracks; see search_tracks.h.

#include "search_tracks.h"

#include "bound.h"
#include "error.h"
#include "search_with_kernel.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/fixed_radius_near_tracks.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

namespace near_pairs {
namespace {

// Integers as the times of a kernel, without rounding.
template <class FT>
FT time_as(std::int64_t tick)
{
  if constexpr(std::is_floating_point_v<FT>) {
    if(tick > std::int64_t(1) << 53)
      throw Error("times differ by more than 53 bits; use --kernel exact");
    return static_cast<FT>(tick);
  }
  else
    return to_rational(*parse_decimal(std::to_string(tick)));
}

// The first conversion to a double may be wrong by many ticks, the second one is of few.
std::pair<std::int64_t, double> tick_and_part(const CGAL::Exact_rational& time)
{
  const auto near = static_cast<std::int64_t>(CGAL::to_double(time));
  const double rest
    = CGAL::to_double(CGAL::Exact_rational(time - time_as<CGAL::Exact_rational>(near)));
  const double whole = std::floor(rest);
  return {near + static_cast<std::int64_t>(whole), rest - whole};
}

// The tracks for the library, which knows nothing of gaps: each piece is a track of its own. Pieces
// of one track are there at different times, and so never near.
template <class Kernel>
class Track_search
{
  using FT = typename Kernel::FT;
  using Point = typename Kernel::Point_3;
  using Path = std::vector<std::pair<FT, Point>>;
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

public:
  Track_search(const Tracks& tracks, const Options& options)
    : tracks_(tracks), options_(options),
      bound_(bound_of(options, tracks.scene.scale))
  {
    const std::vector<Point> points = points_of<Kernel>(tracks.scene);
    for(std::size_t i = 0; i < tracks.tracks.size(); ++i) {
      if(i == tracks.first_size)
        first_paths_ = paths_.size();
      first_path_.push_back(paths_.size());
      for(const Piece& piece : tracks.tracks[i].pieces) {
        Path& path = paths_.emplace_back();
        for(const Fix& fix : piece)
          path.emplace_back(time_as<FT>(fix.tick), points[fix.point]);
        track_of_path_.push_back(i);
      }
    }
    first_path_.push_back(paths_.size());
    if(tracks.first_size == tracks.tracks.size())
      first_paths_ = paths_.size();
  }

  // Looks a little beyond the bound, where rounded decimals may have moved pairs.
  Track_result operator()()
  {
    const double excess = excess_of_longer_bound(options_, tracks_.scene.rounding);
    Track_result result;
    for(const auto& [i, j] : pairs(excess == 0 ? bound_ : longer_bound_of(options_, excess),
                                   result.tier)) {
      if(stop_requested)
        throw Error("stopped");
      const CGAL::Closest_approach approach = *approach_of(i, j);
      const auto order = compare(approach.squared_distance);
      const bool is_found = options_.open ? order < 0 : order <= 0;
      const bool is_tie
        = options_.open ? is_found && length(approach) >= reach_of(options_) - excess : order > 0;
      result.has_moved_ties |= is_tie && excess != 0;
      result.on_boundary += is_found && order == 0;
      if(is_found) {
        const auto [tick, part] = tick_and_part(approach.time);
        result.pairs.push_back({i, j, tick, part, length(approach)});
      }
    }
    return result;
  }

private:
  // The pairs of tracks, each once.
  Pairs pairs(const Exact_bound& bound, std::string& tier) const
  {
    Pairs pairs;
    std::mutex mutex; // the library may call from several threads
    const std::size_t offset = options_.files.size() == 2 ? first_paths_ : 0;
    const auto add = [&](std::size_t i, std::size_t j) {
      const std::size_t a = track_of_path_[i], b = track_of_path_[offset + j];
      const std::lock_guard<std::mutex> lock(mutex);
      pairs.emplace_back(a, b);
    };
    CGAL::Scene_profile profile;
    if(!report(bound, add, profile))
      throw Error("stopped");
    Search_result description;
    describe(profile, description);
    tier = description.tier;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  // Returns false iff the search was stopped.
  template <class Callback>
  bool report(const Exact_bound& bound, Callback& callback, CGAL::Scene_profile& profile) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(options_.parallel)
      return report_by<CGAL::Parallel_tag>(bound, callback, profile);
#endif
    return report_by<CGAL::Sequential_tag>(bound, callback, profile);
  }

  template <class ConcurrencyTag, class Callback>
  bool report_by(const Exact_bound& bound, Callback& callback, CGAL::Scene_profile& profile) const
  {
    const auto go_on = progress_functor(options_.progress);
    const auto parameters = CGAL::parameters::callback(go_on);
    if(options_.files.size() == 1)
      return CGAL::fixed_radius_near_tracks<ConcurrencyTag>(paths_, bound, callback, profile,
                                                            parameters);
    const auto [first, second] = ranges_of(paths_, first_paths_);
    return CGAL::fixed_radius_near_tracks<ConcurrencyTag>(first, second, bound, callback, profile,
                                                          parameters);
  }

  // The part of a path that tells where it is between two times, both of which it has.
  static auto part_between(const Path& path, const FT& begin, const FT& end)
  {
    const auto first = std::partition_point(
      std::next(path.begin()), path.end(), [&](const auto& fix) { return fix.first <= begin; });
    const auto last = std::partition_point(
      first, path.end(), [&](const auto& fix) { return fix.first < end; });
    return CGAL::make_range(std::prev(first), last == path.end() ? last : std::next(last));
  }

  // Only the parts at common times are read: a long piece may meet very many short ones.
  static std::optional<CGAL::Closest_approach> approach_of_paths(const Path& a, const Path& b)
  {
    const FT& begin = std::max(a.front().first, b.front().first);
    const FT& end = std::min(a.back().first, b.back().first);
    if(end < begin)
      return std::nullopt;
    return CGAL::closest_approach(part_between(a, begin, end), part_between(b, begin, end));
  }

  // The closest approach of two tracks: that of two of their pieces. Of two pieces, the one that
  // ends first has no time in common with those that come next.
  std::optional<CGAL::Closest_approach> approach_of(std::size_t a, std::size_t b) const
  {
    std::optional<CGAL::Closest_approach> best;
    std::size_t i = first_path_[a], j = first_path_[b];
    while(i < first_path_[a + 1] && j < first_path_[b + 1]) {
      const auto approach = approach_of_paths(paths_[i], paths_[j]);
      if(approach && (!best || approach->squared_distance < best->squared_distance))
        best = approach;
      const bool ends_first = paths_[i].back().first <= paths_[j].back().first;
      i += ends_first;
      j += !ends_first;
    }
    return best;
  }

  // Compares a squared distance with the distance that was typed: -1, 0 or 1.
  int compare(const CGAL::Exact_rational& squared_distance) const
  {
    const CGAL::Exact_rational& typed = bound_.value();
    const CGAL::Exact_rational squared = bound_.is_squared() ? typed
                                                             : CGAL::Exact_rational(typed * typed);
    return squared_distance < squared ? -1 : squared < squared_distance ? 1 : 0;
  }

  // In the unit of the file. A square may be out of the range of doubles, where its root is not.
  double length(const CGAL::Closest_approach& approach) const
  {
    const double rounded = CGAL::to_double(approach.squared_distance);
    const double unit = rounded > 1e300 ? 1e155 : rounded < 1e-280 ? 1e-153 : 1;
    const CGAL::Exact_rational squared
      = approach.squared_distance / CGAL::Exact_rational(unit) / CGAL::Exact_rational(unit);
    double result = std::sqrt(CGAL::to_double(squared)) * unit;
    const int most = 300; // larger powers of ten may be infinite
    for(int scale = tracks_.scene.scale; scale > 0; scale -= most)
      result /= std::pow(10., std::min(scale, most));
    return result;
  }

  const Tracks& tracks_;
  const Options& options_;
  const Exact_bound bound_;
  std::vector<Path> paths_;
  std::vector<std::size_t> track_of_path_, first_path_; // of a track
  std::size_t first_paths_ = 0; // of the tracks of the first file
};

} // namespace

Track_result search_tracks(const Tracks& tracks, const Options& options)
{
  if(options.kernel == "exact")
    return Track_search<CGAL::Simple_cartesian<CGAL::Exact_rational>>(tracks, options)();
  return Track_search<CGAL::Exact_predicates_inexact_constructions_kernel>(tracks, options)();
}

} // namespace near_pairs
