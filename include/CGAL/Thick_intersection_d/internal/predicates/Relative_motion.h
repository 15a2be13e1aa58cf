// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_RELATIVE_MOTION_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_RELATIVE_MOTION_H

// How one of two points that move uniformly sees the other one, in exact numbers or in integers:
// the vector w from one to the other when their common time begins, and the velocity v. The
// distance is least at an end of the common time, or in between if w.v < 0 at the first end and
// w.v > 0 at the last. Then it is |w x v| / |v|.
//
// If both legs have the same times, w has degree 1, and so has v in units of this time. Otherwise
// vectors are multiplied by both durations: w has degree 3, and v has degree 2. A bound on the
// distance has degree 1. So the comparison |w x v|^2 <= r^2 |v|^2 has degree 4 or 10.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>
#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Number, std::size_t N>
struct Exact_leg
{
  std::array<Exact_vector<Number, N>, 2> ends;
  std::array<Number, 2> times;
};

template <class Number, std::size_t N>
class Relative_motion
{
  using Vector = Exact_vector<Number, N>;
  using Leg = Exact_leg<Number, N>;

public:
  Relative_motion(const Leg& a, const Leg& b)
    : times_{(std::max)(a.times[0], b.times[0]), (std::min)(a.times[1], b.times[1])}
  {
    if(a.times[0] == b.times[0] && a.times[1] == b.times[1])
      set_common(a, b);
    else
      set_scaled(a, b);
    begins_along_ = dot_product(ends_[0], velocity_);
    ends_along_ = dot_product(ends_[1], velocity_);
  }

  // Whether the legs have a time in common. If not, nothing else has a meaning.
  bool has_time() const { return times_[0] <= times_[1]; }

  // Returns the square of the least distance, as a numerator and a denominator.
  std::pair<Number, Number> least_square() const
  {
    const Number square(scale_ * scale_);
    if(is_least_between())
      return {square_of_cross(), Number(dot_product(velocity_, velocity_) * square)};
    return {dot_product(ends_[nearest_end()], ends_[nearest_end()]), square};
  }

  // Returns the first time of the least distance.
  Number time_of_least() const
  {
    if(!is_least_between())
      return times_[nearest_end()];
    const Number share(begins_along_ / (begins_along_ - ends_along_));
    return Number(times_[0] + (times_[1] - times_[0]) * share);
  }

private:
  void set_common(const Leg& a, const Leg& b)
  {
    for(std::size_t k = 0; k < 2; ++k)
      ends_[k] = vector_difference(b.ends[k], a.ends[k]);
    velocity_ = vector_difference(ends_[1], ends_[0]);
    scale_ = Number(1);
  }

  // A leg that lasts for no time has no way either.
  void set_scaled(const Leg& a, const Leg& b)
  {
    const Number duration_a = duration(a), duration_b = duration(b);
    const Vector way_a = vector_difference(a.ends[1], a.ends[0]);
    const Vector way_b = vector_difference(b.ends[1], b.ends[0]);
    scale_ = Number(duration_a * duration_b);
    for(std::size_t i = 0; i < N; ++i) {
      velocity_[i] = Number(duration_a * way_b[i] - duration_b * way_a[i]);
      for(std::size_t k = 0; k < 2; ++k) {
        const Number since_a(times_[k] - a.times[0]), since_b(times_[k] - b.times[0]);
        ends_[k][i] = Number(scale_ * (b.ends[0][i] - a.ends[0][i])
                             + duration_a * since_b * way_b[i] - duration_b * since_a * way_a[i]);
      }
    }
  }

  static Number duration(const Leg& leg)
  {
    return leg.times[0] == leg.times[1] ? Number(1) : Number(leg.times[1] - leg.times[0]);
  }

  bool is_least_between() const { return begins_along_ < Number(0) && ends_along_ > Number(0); }

  // The first one if both are as near. Only if the distance is not least between them.
  std::size_t nearest_end() const { return begins_along_ < Number(0); }

  Number square_of_cross() const
  {
    if constexpr(N == 2) {
      const Number cross(ends_[0][0] * velocity_[1] - ends_[0][1] * velocity_[0]);
      return Number(cross * cross);
    }
    else {
      const Vector cross = exact_normal(ends_[0], velocity_);
      return dot_product(cross, cross);
    }
  }

  const std::array<Number, 2> times_;
  std::array<Vector, 2> ends_; // of w, times scale
  Vector velocity_;            // times scale, if the times of the legs differ
  Number scale_;
  Number begins_along_, ends_along_; // the products of w and v
};

// Legs and a bound on grids of places and of times that have them in few steps, so that integers of
// 128 bits compare their distance with the bound.
template <std::size_t N>
class Integer_legs
{
public:
  Integer_legs(const Leg<N>& a, const Leg<N>& b, double radius)
  {
    Double_grid places, times;
    places.add(radius);
    a.add_to(places, times);
    b.add_to(places, times);
    radius_ = steps_of(radius, places, largest_radius_);
    for(std::size_t k = 0; k < 2; ++k)
      for(std::size_t leg = 0; leg < 2; ++leg) {
        const Leg<N>& from = leg == 0 ? a : b;
        legs_[leg].times[k] = steps_of(from.times[k] - a.times[0], times, largest_time_);
        for(std::size_t i = 0; i < N; ++i)
          legs_[leg].ends[k][i]
            = steps_of(from.ends[k][i] - a.ends[0][i], places, largest_place_);
      }
  }

  // Returns whether the legs are within the bound. Returns nothing if the integers have too few
  // bits.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED std::optional<bool> are_near(bool is_open) const
  {
    if(!is_usable())
      return std::nullopt;
    const Relative_motion<Int128, N> motion(legs_[0], legs_[1]);
    if(!motion.has_time())
      return false;
    const auto [n, d] = motion.least_square();
    const Int128 limit(radius_ * radius_ * d);
    return is_open ? n < limit : n <= limit;
  }

private:
  // All numbers are multiples of the grid, so the difference of two is a double, if it is small. If
  // it overflows, rounding may make the largest double of it, which may be few steps.
  static Int128 steps_of(double x, const Double_grid& grid, double& largest)
  {
    const double steps = std::fabs(x) < 0x1p1023 ? std::ldexp(x, -grid.exponent()) : 0x1p1023;
    largest = (std::max)(largest, std::fabs(steps));
    return std::fabs(steps) < 0x1p62 ? static_cast<std::int64_t>(steps) : 0;
  }

  // Let D be the longest duration, or 1 if the times of the legs are the same, and L the largest
  // coordinate. Then |w_i| <= 4 D^2 L and |v_i| <= 3 D L. So the square of w x v is at most
  // 12 (4 D^2 L 3 D L)^2, and the limit r^2 D^4 |v|^2 at most 3 (r D^2 3 D L)^2.
  bool is_usable() const
  {
    const bool are_common = legs_[0].times == legs_[1].times;
    const double duration = are_common ? 1 : (std::max)(2 * largest_time_, 1.);
    const double square = duration * duration;
    const double velocity = (std::max)(3 * duration * largest_place_, 1.);
    return largest_time_ <= 0x1p52 && 4 * square * largest_place_ * velocity <= 0x1p61
           && square * (std::max)(largest_radius_, 1.) * velocity <= 0x1p61;
  }

  std::array<Exact_leg<Int128, N>, 2> legs_; // from the first end of the first leg
  Int128 radius_;
  double largest_radius_ = 0, largest_place_ = 0, largest_time_ = 0; // in steps
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_RELATIVE_MOTION_H
