// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_LEGS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_LEGS_H

// The legs of tracks, as searches read them: in doubles, in exact numbers, and as boxes in space
// and time. Long legs may be cut into stretches, which have boxes of their own.

#include <CGAL/Exact_rational.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Stretches.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/input/kinds.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Relative_motion.h>
#include <CGAL/Thick_intersection_d/internal/predicates/do_kernel_objects_intersect.h>
#include <CGAL/Thick_intersection_d/internal/tracks/check_tracks.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Fix` is a pair of a time and a point.
template <class Fix>
class Track_legs
{
  using Time = typename Fix::first_type;
  using Point = typename Fix::second_type;
  using Number = Coordinate_t<Point>;
  static constexpr bool are_doubles = is_held_by_double_v<Number> && is_held_by_double_v<Time>;

public:
  static constexpr int dimension = dimension_or<Point>(0);

  // Exact numbers that hold times and coordinates. They hold all doubles.
  using Exact = std::conditional_t<
    is_held_by_double_v<Time> || std::is_same_v<Exact_number_t<Number>, Exact_number_t<Time>>,
    Exact_number_t<Number>, Exact_rational>;

  // Adds the tracks of a range, or of two. A track of one fix has a leg that lasts for no time.
  template <class Tracks>
  void add_tracks(const Tracks& tracks)
  {
    for(std::size_t k = 0; k < tracks.size(); ++k)
      of_range(tracks[k], [&](const auto& track) { add_track(track); });
  }

  template <class Track>
  void add_track(const Track& track)
  {
    const std::size_t first = fixes_.size();
    for(const auto& fix : track)
      add_fix(Fix(fix.first, fix.second), fixes_.size() - first);
    if(fixes_.size() == first + 1)
      fixes_.push_back(fixes_.back());
    const std::size_t count = (std::max)(fixes_.size(), track_count_ + 1);
    if(!fits_box_route(count))
      throw_too_many_objects(count);
    for(std::size_t fix = first; fix + 1 < fixes_.size(); ++fix)
      stretches_.push_back({static_cast<Place>(track_count_), static_cast<Place>(fix), 0, 1});
    ++track_count_;
  }

  std::size_t size() const { return stretches_.size(); }
  std::size_t track_count() const { return track_count_; }
  Place track_of(std::size_t stretch) const { return stretches_[stretch].track; }

  // Returns the first stretch of the tracks at a position or behind it.
  std::size_t first_stretch_from(std::size_t track) const
  {
    const auto is_before = [=](const Stretch_of_leg& stretch) { return stretch.track < track; };
    return static_cast<std::size_t>(
      std::partition_point(stretches_.begin(), stretches_.end(), is_before) - stretches_.begin());
  }

  bool have_one_stretch_each() const
  {
    const auto are_of_one = [](const Stretch_of_leg& a, const Stretch_of_leg& b) {
      return a.track == b.track;
    };
    return std::adjacent_find(stretches_.begin(), stretches_.end(), are_of_one) == stretches_.end();
  }

  void prefetch(std::size_t stretch) const { prefetch_to_read(&fix(stretch, 0)); }

  // Returns the whole leg that a stretch is of.
  Leg<dimension> leg(std::size_t stretch) const
  {
    Leg<dimension> leg;
    for(std::size_t end = 0; end < 2; ++end) {
      leg.times[end] = lower_end(bounds_of(stretch, end, dimension), leg.time_error);
      for(int axis = 0; axis < dimension; ++axis)
        leg.ends[end][axis] = lower_end(bounds_of(stretch, end, axis), leg.error);
    }
    return leg;
  }

  template <class ExactNumber>
  Exact_leg<ExactNumber, dimension> exact_leg(std::size_t stretch) const
  {
    Exact_leg<ExactNumber, dimension> leg;
    for(std::size_t end = 0; end < 2; ++end) {
      leg.times[end] = to_exact<ExactNumber>(fix(stretch, end).first);
      for(int axis = 0; axis < dimension; ++axis)
        leg.ends[end][axis] = to_exact<ExactNumber>(coordinate(fix(stretch, end).second, axis));
    }
    return leg;
  }

  // Whether all legs begin at the same time, and end at the same time.
  bool have_common_times() const
  {
    for(std::size_t i = 1; i < size(); ++i)
      if(fix(i, 0).first != fix(0, 0).first || fix(i, 1).first != fix(0, 1).first)
        return false;
    return true;
  }

  bool ends_before(std::size_t i, std::size_t j) const
  {
    return fix(i, 1).first < fix(j, 1).first;
  }

  // Returns what a stretch covers along an axis of space, or in time, which is the last axis.
  Interval interval(std::size_t stretch, int axis) const
  {
    return interval(stretch, axis, stretches_[stretch].index, stretches_[stretch].count);
  }

  // The same for a stretch of a leg that is not cut, or would be one of `count`.
  Interval interval(std::size_t leg, int axis, Place index, Place count) const
  {
    const auto end = [&](std::size_t k) -> Interval {
      const std::pair<double, double> bounds = finite_interval(bounds_of(leg, k, axis));
      return {bounds.first, bounds.second};
    };
    return interval_of_stretch(end(0), end(1), index, count);
  }

  // Cuts each leg into a number of stretches. The legs must not be cut.
  void cut(const std::vector<Place>& counts)
  {
    std::vector<Stretch_of_leg> stretches;
    for(std::size_t i = 0; i < counts.size(); ++i)
      for(Place k = 0; k < counts[i]; ++k)
        stretches.push_back({stretches_[i].track, stretches_[i].fix, k, counts[i]});
    stretches_ = std::move(stretches);
  }

private:
  struct Stretch_of_leg
  {
    Place track;
    Place fix; // at which the leg begins
    Place index;
    Place count; // of the stretches of the leg
  };

  // Adds a fix of the last track, which has so many already.
  void add_fix(const Fix& fix, std::size_t number)
  {
    check_fix(fix, number, track_count_);
    if(number != 0 && !(fixes_.back().first < fix.first))
      throw_wrong_time(number, track_count_, " is not later than that of the fix before.");
    settle(fix.second);
    if constexpr(Is_lazy<Time>::value)
      CGAL::exact(fix.first);
    fixes_.push_back(fix);
  }

  const Fix& fix(std::size_t stretch, std::size_t end) const
  {
    return fixes_[stretches_[stretch].fix + end];
  }

  // Encloses a coordinate, or the time, which is the last one.
  std::pair<double, double> bounds_of(std::size_t stretch, std::size_t end, int axis) const
  {
    const Fix& fix = this->fix(stretch, end);
    return axis == dimension ? bounds(fix.first) : coordinate_bounds(fix.second, axis);
  }

  // Returns the lower one of two bounds, and raises the error to their distance.
  static double lower_end(const std::pair<double, double>& bounds, [[maybe_unused]] double& error)
  {
    if constexpr(!are_doubles)
      error = (std::max)(error, bounds.second - bounds.first);
    return bounds.first;
  }

  std::vector<Fix> fixes_;
  std::vector<Stretch_of_leg> stretches_;
  std::size_t track_count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_TRACK_LEGS_H
