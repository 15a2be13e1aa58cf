// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FIXED_RADIUS_NEAR_TRACKS_H
#define CGAL_FIXED_RADIUS_NEAR_TRACKS_H

// Points that move: all pairs of tracks that come within a distance at some time.

#include <CGAL/Distance_bound.h>
#include <CGAL/Element_callback.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/closest_approach.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/lists/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>
#include <CGAL/Thick_intersection_d/internal/tracks/track_pairs_search.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of tracks of a range that are within a bound of each other at some time, each pair
exactly once.

A *track* is a range of *fixes*, which are pairs of a time and a point: `std::pair<Time, Point>`,
with points in the plane or in space. Times increase strictly. From one fix to the next one, the
point moves uniformly along a straight line. It exists from the first time of its track to the last:
at one instant if there is one fix, and never if there is none. So points that move with constant
velocities during the same time are tracks of two fixes. A `std::map` from times to points is a
track as well.

Two tracks are near if, at some time at which both exist, the distance of their points is within the
bound. Tracks that exist at one common instant only are compared at this instant. The search gives
the result of real arithmetic on the given times, coordinates and bound, for every kernel, and for
tracks whose least distance is exactly the bound. A track is never paired with itself.

The search takes the *legs* between two fixes through the divide and conquer of
`thick_self_intersection_d()`, as boxes in space and time. If a sample of legs shows that this takes
less time, long legs are cut into stretches of time first. It compares legs whose boxes are within
the bound along each axis of space and meet in time, as long as their tracks are not known to be a
pair. A filter in doubles decides nearly all comparisons. The algebraic degree is 4 if both legs
have the same times, and 10 otherwise. Then integers of 128 bits decide where a grid of coordinates
and times allows it, and exact numbers elsewhere.

Let there be \f$ n \f$ legs and \f$ k \f$ reported pairs. Let \f$ K \f$ be the number of pairs of
legs, or of their stretches, of different tracks whose boxes meet, before the tracks are known to be
a pair. Let \f$ K_f \f$ be the number of pairs of a leg or stretch and a track that form a reported
pair of tracks, if the box of the leg meets one of the track. The search takes \f$ O((n + K_f)
\log^d n + K) \f$ time, where \f$ d \f$ is the dimension of space, and \f$ O(n + k) \f$ space.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel, the same pairs are reported
in any order. Several threads call the callback at once, so it must allow this. `Parallel_tag`
requires \tbb.

\tparam TrackRange is a range of tracks with forward iterators or better. It is not reordered. The
fixes are copied.

\tparam NT is a number type as described for `Distance_bound`. The number types of times and
coordinates may differ. All their values are rational numbers.

\tparam Callback is as for `fixed_radius_near_neighbors()`.

\param tracks the tracks.
\param bound made by `within_distance()` or `within_squared_distance()`, in the unit of the
coordinates.
\param callback is called for each pair, with the positions \f$ i < j \f$ of the two tracks in the
range, or with the elements at these positions.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating tracks to the elements of the range}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to tracks}
    \cgalParamDefault{the elements are the tracks}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor that is called with the progress between 0 and 1, and cancels
                          the search by returning `false`}
    \cgalParamType{a functor with `bool operator()(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{In parallel, one thread at a time calls it, but not always the same thread.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument if a time or a coordinate is NaN or infinite, if a time is not later
than that of the fix before, or if the bound is negative or NaN, before anything is reported. The
message gives the position of the track, and of the fix in it. Exceptions of the callback pass
through.
\throws std::length_error if there are 2<sup>31</sup> - 1 tracks or fixes, or more, where one fix
of a track alone counts as two.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `closest_approach()`
\sa `fixed_radius_near_neighbors()`
\sa `with_elements()`
*/
template <class ConcurrencyTag = Sequential_tag, class TrackRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_tracks(TrackRange&& tracks, const Distance_bound<NT>& bound,
                              Callback&& callback,
                              const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::track_search(bound, nullptr, np, threads);
  return internal::search_ranges(callback, np, threads, search, tracks);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of tracks of a range that are within a bound of each other at some time, as the
version above, and describes the scene and the search in `profile`.

The axes of the profile are those of space, and time as the last one. `Scene_profile::size()` is the
number of tracks, and the degree is 4 if all legs have the same times, or 10. One grid holds times,
coordinates and the bound. Integers of 128 bits may decide even if this grid is too fine for them:
then each pair of legs has coarser grids, one of its places and one of its times. They do not if
`Scene_profile::force_tier()` has forced exact numbers.

\param tracks,bound,callback,np as in the version above.
\param profile is replaced by the profile of the tracks and the bound, with the same tier forced,
and with the numbers of pairs of legs that each kind of arithmetic has decided. It does not change
if the function throws.

\throws std::invalid_argument as the version above, and if the forced tier is not exact for the
scene.
*/
template <class ConcurrencyTag = Sequential_tag, class TrackRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_tracks(TrackRange&& tracks, const Distance_bound<NT>& bound,
                              Callback&& callback, Scene_profile& profile,
                              const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::track_search(bound, &profile, np, threads);
  return internal::search_ranges(callback, np, threads, search, tracks);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a track of one range and a track of another that are within a bound of each
other at some time, each exactly once.

Pairs within a range are neither reported nor tested. Otherwise the function is as the version for
one range, where \f$ n \f$ is the number of legs of both ranges.

\param tracks_a, tracks_b the tracks. Their times and points have the same types.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param callback is called for each pair with the position \f$ i \f$ of its track in `tracks_a` and
the position \f$ j \f$ of its track in `tracks_b`, or with the elements at these positions.
\param np as for the version for one range; the property map is applied to both ranges.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as the version for one range. Positions in the message go on from the
first range to the second range.
*/
template <class ConcurrencyTag = Sequential_tag, class TrackRangeA, class TrackRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_tracks(TrackRangeA&& tracks_a, TrackRangeB&& tracks_b,
                              const Distance_bound<NT>& bound, Callback&& callback,
                              const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::track_search(bound, nullptr, np, threads);
  return internal::search_ranges(callback, np, threads, search, tracks_a, tracks_b);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a track of one range and a track of another that are within a bound of each
other at some time, as the version above. The profile is as in the version for one range, for the
tracks of both ranges.
*/
template <class ConcurrencyTag = Sequential_tag, class TrackRangeA, class TrackRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_tracks(TrackRangeA&& tracks_a, TrackRangeB&& tracks_b,
                              const Distance_bound<NT>& bound, Callback&& callback,
                              Scene_profile& profile,
                              const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::track_search(bound, &profile, np, threads);
  return internal::search_ranges(callback, np, threads, search, tracks_a, tracks_b);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each track of a range all others that are within a bound of it at some time.

The pairs are those of `fixed_radius_near_tracks()`, and the lists are as those of
`fixed_radius_neighbor_lists()`: each is sorted, and they are the same for any number of threads.

\param tracks,bound,np as for `fixed_radius_near_tracks()`.

\return the lists. If the progress functor cancels the search, they hold some of the pairs, each in
both lists.

\throws std::invalid_argument, std::length_error, std::runtime_error as
`fixed_radius_near_tracks()`.
*/
template <class ConcurrencyTag = Sequential_tag, class TrackRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Neighbor_lists fixed_radius_track_lists(TrackRange&& tracks, const Distance_bound<NT>& bound,
                                        const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::track_search(bound, nullptr, np, threads);
  Neighbor_lists lists;
  internal::collect_lists(lists, np, threads, search, tracks);
  return lists;
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each track of a range all tracks of another range that are within a bound of it at some
time.

The lists are those of the tracks of `tracks_a`, and hold positions in `tracks_b`. Otherwise the
function is as the version for one range.
*/
template <class ConcurrencyTag = Sequential_tag, class TrackRangeA, class TrackRangeB, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Neighbor_lists fixed_radius_track_lists(TrackRangeA&& tracks_a, TrackRangeB&& tracks_b,
                                        const Distance_bound<NT>& bound,
                                        const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::track_search(bound, nullptr, np, threads);
  Neighbor_lists lists;
  internal::collect_lists(lists, np, threads, search, tracks_a, tracks_b);
  return lists;
}

#ifndef DOXYGEN_RUNNING
// Bare numbers as bounds: each call that has one stops with a sentence that says so.
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, bool>
fixed_radius_near_tracks(const Arguments&...)
{
  return Thick_intersection_d::internal::check_bound<Arguments...>();
}
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, Neighbor_lists>
fixed_radius_track_lists(const Arguments&...)
{
  Thick_intersection_d::internal::check_bound<Arguments...>();
  return {};
}
#endif

} // namespace CGAL

#endif // CGAL_FIXED_RADIUS_NEAR_TRACKS_H
