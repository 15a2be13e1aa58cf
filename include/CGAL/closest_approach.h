// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_CLOSEST_APPROACH_H
#define CGAL_CLOSEST_APPROACH_H

// When are two points that move closest, and how close?

#include <CGAL/Exact_rational.h>

#include <CGAL/Thick_intersection_d/internal/tracks/closest_approach_search.h>

#include <optional>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

is when two tracks are closest, and how close. Both numbers are exact.
*/
struct Closest_approach
{
  /// the first time at which the distance is least, in the unit of the times of the tracks.
  Exact_rational time;
  /// the square of the distance at this time.
  Exact_rational squared_distance;
};

/*!
\ingroup PkgThickIntersectionDRef

returns the closest approach of two tracks, or nothing if they do not exist at a common time.

Tracks are as for `fixed_radius_near_tracks()`. Two tracks are near there iff they have a closest
approach whose squared distance is within the bound. Both results are rational numbers, and exact:
nothing is rounded. The function takes \f$ O(m) \f$ time and space for tracks of \f$ m \f$ fixes.
Doubles find the legs that may be closest, and exact numbers compare these.

\tparam TrackA, TrackB are ranges of `std::pair<Time, Point>` with forward iterators or better, and
with the same types of times and points.

\param a, b the tracks.

\throws std::invalid_argument if a time or a coordinate is NaN or infinite, or if a time is not
later than that of the fix before. The message numbers the tracks 0 and 1.
\throws std::length_error if they have 2<sup>31</sup> - 1 fixes or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `fixed_radius_near_tracks()`
*/
template <class TrackA, class TrackB>
std::optional<Closest_approach> closest_approach(const TrackA& a, const TrackB& b)
{
  return Thick_intersection_d::internal::find_closest_approach<Closest_approach>(a, b);
}

} // namespace CGAL

#endif // CGAL_CLOSEST_APPROACH_H
