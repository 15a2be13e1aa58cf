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
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_simplex.h>

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

// The vector from the point of one leg to that of another, from the first common time to the last.
template <std::size_t N>
class Relative_segment
{
  using Vector = std::array<double, N>;

public:
  Relative_segment(const Leg<N>& a, const Leg<N>& b)
    : common_({(std::max)(a.times[0], b.times[0]), (std::min)(a.times[1], b.times[1])}),
      time_error_(a.time_error + b.time_error),
      longest_((std::max)(a.duration(), b.duration())),
      shortest_((std::min)(a.duration(), b.duration()))
  {
    const std::array<double, 2> times = {common_.low, common_.high};
    double largest = 0;
    std::array<double, 2> shares_a, shares_b;
    for(std::size_t k = 0; k < 2; ++k) {
      shares_a[k] = a.share_at(times[k]);
      shares_b[k] = b.share_at(times[k]);
    }
    for(std::size_t i = 0; i < N; ++i) {
      const double a1 = a.ends[1][i] - a.ends[0][i];
      const double b0 = b.ends[0][i] - a.ends[0][i], b1 = b.ends[1][i] - a.ends[0][i];
      largest = (std::max)({largest, std::fabs(a1), std::fabs(b0), std::fabs(b1)});
      for(std::size_t k = 0; k < 2; ++k)
        ends_[k][i] = b0 + (b1 - b0) * shares_b[k] - a1 * shares_a[k];
    }
    set_slack(largest, a.error + b.error);
  }

  // Encloses the distance. It is infinite if the legs certainly have no time in common. Nothing is
  // known of it if that is not certain, or if numbers are too large.
  Interval distance() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if(common_.length() < -time_error_)
      return {infinity, infinity};
    if(!(common_.length() >= time_error_ && longest_ <= 0x1p1000 && slack_ <= 0x1p355))
      return {-infinity, infinity};
    const Vector v = nearest_point();
    const double length = std::sqrt(dot_product(v, v));
    const double least = (std::min)(dot_product(v, ends_[0]), dot_product(v, ends_[1]));
    return {least / (length + 0x1p-460) - slack_, length + slack_};
  }

private:
  // Times that are off by e move shares by up to 3e over the duration of a leg.
  void set_slack(double largest, double error)
  {
    largest = (std::max)(largest, 0x1p-400);
    if(time_error_ != 0)
      error += 16 * (largest + error) * (time_error_ / shortest_);
    slack_ = 0x1p-45 * (std::max)(largest, 0x1p48 * error);
  }

  // Returns a point that is on the segment, but for rounding, and nearest to the origin, unless
  // products underflow.
  Vector nearest_point() const
  {
    const Vector way = vector_difference(ends_[1], ends_[0]);
    const double along = -dot_product(ends_[0], way), square = dot_product(way, way);
    const double share = !(along > 0) ? 0 : along >= square ? 1 : along / square;
    Vector v = ends_[0];
    for(std::size_t i = 0; i < N; ++i)
      v[i] += way[i] * share;
    return v;
  }

  const Interval common_;
  const double time_error_;
  const double longest_, shortest_; // of the durations
  std::array<Vector, 2> ends_;
  double slack_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_LEG_H
