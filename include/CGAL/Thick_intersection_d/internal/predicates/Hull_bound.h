// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_BOUND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_BOUND_H

// A bound on the distance of two hulls as doubles know it, and the integers that decide where
// doubles do not.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/wide_integers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Hull_bound
{
  Interval radius = {0, 0};  // encloses the bound on the distance
  bool is_exact_radius = true; // whether its lower end is the bound
  bool is_open = false;
};

// Sets `result` to a bound, which is `squared` as well.
template <class NT, class Exact>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
void set_hull_bound(Hull_bound& result, const Distance_bound<NT>& bound,
                                       const Squared_bound<Exact>& squared)
{
  const std::pair<double, double> value = bounds(bound.value());
  result.is_open = bound.is_open();
  result.is_exact_radius = !bound.is_squared() && value.first == value.second;
  result.radius.high = squared.reach();
  result.radius.low = result.is_exact_radius
                        ? value.first : std::nextafter(std::sqrt(squared.squared().first), 0.);
}

// Returns doubles that enclose the sum of the bound and of the radii.
inline Interval reach_of_hulls(const Hull_bound& bound, const Interval& radius_of_a,
                               const Interval& radius_of_b)
{
  const double low = bound.radius.low + radius_of_a.low + radius_of_b.low;
  const double high = bound.radius.high + radius_of_a.high + radius_of_b.high;
  return {low * (1 - 0x1p-50), high * (1 + 0x1p-50)};
}

// Hulls and a bound on a grid that has them in few steps, so that integers of 128 bits compare
// their distance with the bound.
template <int Dimension>
class Integer_hulls
{
  using Doubles = std::vector<std::array<double, Dimension>>;
  using Vector = Exact_vector<Int128, Dimension>;

public:
  // The hulls have these vertices and radii.
  Integer_hulls(const Doubles& a, const Doubles& b, double radius_of_a, double radius_of_b,
                double radius)
    : a_(a), b_(b)
  {
    for(const double x : {radius_of_a, radius_of_b, radius})
      grid_.add(x);
    for(const Doubles* hull : {&a, &b})
      for(const std::array<double, Dimension>& vertex : *hull)
        for(const double x : vertex)
          grid_.add(x);
    // If a difference overflows, rounding may make the largest double of it: many steps below this.
    is_usable_ = grid_.exponent() < 990;
    reach_ = steps(radius_of_a) + steps(radius_of_b) + steps(radius);
  }

  // Returns whether hulls that are apart are within the bound. Returns nothing if the integers have
  // too few bits.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED std::optional<bool> are_near(bool is_open)
  {
    const std::vector<Vector> a = vectors_to(a_), b = vectors_to(b_);
    if(!is_usable_)
      return std::nullopt;
    const auto within = [&](const Int128& n, const Int128& d) {
      return is_open ? n < reach_ * reach_ * d : n <= reach_ * reach_ * d;
    };
    return Exact_hull_distance<Int128, Dimension, decltype(within)>(within)(a, b);
  }

private:
  // Differences have at most these bits, and so has the reach. See distance_bits().
  static constexpr int max_bits = Dimension == 2 ? 30 : 20;

  Int128 steps(double x)
  {
    const double steps = std::ldexp(x, -grid_.exponent());
    is_usable_ = is_usable_ && std::fabs(steps) < std::ldexp(1., max_bits - 2);
    return is_usable_ ? static_cast<std::int64_t>(steps) : 0;
  }

  // From the first vertex. All numbers are multiples of the grid, so the difference of two is a
  // double, if it is small.
  std::vector<Vector> vectors_to(const Doubles& points)
  {
    std::vector<Vector> vectors;
    for(const std::array<double, Dimension>& p : points) {
      Vector v;
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        v[axis] = steps(p[axis] - a_[0][axis]);
      vectors.push_back(v);
    }
    return vectors;
  }

  const Doubles& a_;
  const Doubles& b_;
  bool is_usable_;
  Double_grid grid_;
  Int128 reach_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_BOUND_H
