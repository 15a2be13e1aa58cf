// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_LEG_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_LEG_H

// A leg of a track: a point that moves uniformly along a segment. How close do the points of two
// legs come, as far as doubles tell?
//
// Seen from one point, the other one moves along a segment, during the time that both legs have in
// common. The distance is that of the origin from this segment. The vectors to its ends are known
// up to an error. For any vector v, the least product of v and one of them, over |v|, is at most
// the distance; and |v| is at least the distance if v ends on the segment. So two numbers enclose
// the distance, however v was found.
//
// Let M be the largest absolute value of a coordinate, after the first end of the first leg was
// subtracted from all, and w = 2^-52, which bounds the error of an operation in every rounding
// mode.
// - The share of a leg that is over at a time is off by less than 4w.
// - Differences of ends are up to 2M and off by 4wM. A point on the way is off by less than 18wM,
//   or by 6wM on the first leg, and the difference of two points by 26wM along each axis.
// - So the least product is off by less than 59wM|v|, and the end of v by less than 70wM.
// - The length of v, the quotient and the comparisons are off by less than 16wM.
// The slack is 128wM. The constants 2^-400 and 2^-460 make up for underflow: a share that
// underflows is off by less than 2^-1073, and M counts as 2^-400 at least. Products of numbers up
// to 2^400 do not overflow, nor do differences of times up to 2^1000.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <std::size_t N>
struct Leg
{
  std::array<std::array<double, N>, 2> ends;
  std::array<double, 2> times;
  // No coordinate or time is less than its double, or larger by more than the error.
  double error = 0;
  double time_error = 0;

  double duration() const { return times[1] - times[0]; }

  // Whether the doubles are the leg.
  bool is_exact() const { return error == 0 && time_error == 0; }

  // Refines the grids until they hold the coordinates and the times.
  void add_to(Double_grid& places, Double_grid& of_times) const
  {
    for(std::size_t end = 0; end < 2; ++end) {
      of_times.add(times[end]);
      for(const double x : ends[end])
        places.add(x);
    }
  }

  // Returns which share of the leg is over. A leg that lasts for no time has not begun.
  double share_at(double time) const
  {
    return time <= times[0] ? 0 : (time - times[0]) / duration();
  }
};

// Sets `ends` to the vectors from the point of one leg to that of another at two times. Returns the
// largest coordinate of both legs, from the first end of the first leg on, or a bound on underflow.
template <std::size_t N>
BOOST_FORCEINLINE double set_relative_ends(std::array<std::array<double, N>, 2>& ends,
                                           const Leg<N>& a, const Leg<N>& b,
                                           const std::array<double, 2>& times)
{
  double largest = 0x1p-400;
  const std::array<double, 2> shares_a = {a.share_at(times[0]), a.share_at(times[1])};
  const std::array<double, 2> shares_b = {b.share_at(times[0]), b.share_at(times[1])};
  for(std::size_t i = 0; i < N; ++i) {
    const double a1 = a.ends[1][i] - a.ends[0][i];
    const double b0 = b.ends[0][i] - a.ends[0][i], b1 = b.ends[1][i] - a.ends[0][i];
    largest = (std::max)({largest, std::fabs(a1), std::fabs(b0), std::fabs(b1)});
    for(std::size_t k = 0; k < 2; ++k)
      ends[k][i] = b0 + (b1 - b0) * shares_b[k] - a1 * shares_a[k];
  }
  return largest;
}

// Returns a point that is on a segment, but for rounding, and nearest to the origin, unless
// products underflow.
template <std::size_t N>
BOOST_FORCEINLINE
std::array<double, N> nearest_point(const std::array<std::array<double, N>, 2>& ends)
{
  const std::array<double, N> way = vector_difference(ends[1], ends[0]);
  const double along = -dot_product(ends[0], way), square = dot_product(way, way);
  const double share = !(along > 0) ? 0 : along >= square ? 1 : along / square;
  std::array<double, N> v = ends[0];
  for(std::size_t i = 0; i < N; ++i)
    v[i] += way[i] * share;
  return v;
}

// Encloses the distance of the points of two legs. It is infinite if the legs certainly have no
// time in common. Nothing is known of it if that is not certain, or if numbers are too large. It is
// inline by force: legs that all cross take a quarter longer if it is called.
template <std::size_t N>
BOOST_FORCEINLINE Interval distance_of(const Leg<N>& a, const Leg<N>& b)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Interval common = {(std::max)(a.times[0], b.times[0]), (std::min)(a.times[1], b.times[1])};
  const double time_error = a.time_error + b.time_error;
  if(common.length() < -time_error)
    return {infinity, infinity};
  std::array<std::array<double, N>, 2> ends;
  const double largest = set_relative_ends(ends, a, b, {common.low, common.high});
  double error = a.error + b.error;
  if(time_error != 0) // times that are off by e move shares by up to 3e over the duration of a leg
    error += 16 * (largest + error) * (time_error / (std::min)(a.duration(), b.duration()));
  // The error of numbers beyond the doubles is infinite, or NaN, which max() keeps if it is first.
  const double slack = 0x1p-45 * (std::max)(0x1p48 * error, largest);
  if(!(common.length() >= time_error && (std::max)(a.duration(), b.duration()) <= 0x1p1000
       && slack <= 0x1p355))
    return {-infinity, infinity};
  const std::array<double, N> v = nearest_point(ends);
  const double length = std::sqrt(dot_product(v, v));
  const double least = (std::min)(dot_product(v, ends[0]), dot_product(v, ends[1]));
  return {least / (length + 0x1p-460) - slack, length + slack};
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_LEG_H
