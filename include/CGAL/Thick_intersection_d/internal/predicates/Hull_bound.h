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
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Hull_distance.h>
#include <CGAL/Thick_intersection_d/internal/predicates/exact_hull_distance.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Hull_bound
{
  Interval radius = {0, 0}; // encloses the bound on the distance
  std::optional<double> exact_radius = 0; // the bound, if it is a double and no square
  bool is_open = false;
};

template <class NT, class Exact>
Hull_bound make_hull_bound(const Distance_bound<NT>& bound, const Squared_bound<Exact>& squared)
{
  Hull_bound result;
  result.radius = {std::nextafter(std::sqrt(squared.squared().first), 0.), squared.reach()};
  result.is_open = bound.is_open();
  const std::pair<double, double> value = bounds(bound.value());
  result.exact_radius.reset();
  if(!bound.is_squared() && value.first == value.second)
    result.exact_radius = value.first;
  return result;
}

// Returns doubles that enclose the sum of the bound and of the radii.
template <int Dimension>
Interval reach_of_hulls(const Hull_bound& bound, const Hull<Dimension>& a, const Hull<Dimension>& b)
{
  const double low = bound.radius.low + a.radius.low + b.radius.low;
  const double high = bound.radius.high + a.radius.high + b.radius.high;
  return {low * (1 - 0x1p-50), high * (1 + 0x1p-50)};
}

// Hulls and a bound on a grid that has them in few steps, so that integers of 128 bits compare
// their distance with the bound.
template <int Dimension>
class Integer_hulls
{
  using Points = Hull<Dimension>;
  using Vector = Exact_vector<Int128, Dimension>;

public:
  Integer_hulls(const Points& a, const Points& b, const Hull_bound& bound)
    : a_(a), b_(b), is_open_(bound.is_open)
  {
    is_usable_ = bound.exact_radius && a.error == 0 && b.error == 0
                 && a.radius.length() == 0 && b.radius.length() == 0;
    if(!is_usable_)
      return;
    grid_.add(*bound.exact_radius);
    for(const Points* hull : {&a, &b}) {
      grid_.add(hull->radius.low);
      for(std::size_t k = 0; k < hull->size; ++k)
        for(const double x : hull->vertices[k])
          grid_.add(x);
    }
    reach_ = steps(*bound.exact_radius) + steps(a.radius.low) + steps(b.radius.low);
  }

  // Returns whether hulls that are apart are within the bound. Returns nothing if the integers have
  // too few bits. `doubles` knows which vertices are needed.
  CGAL_RARELY_CALLED std::optional<bool> are_near(const Hull_distance<Dimension>& doubles)
  {
    std::vector<Vector> vertices_of_a, vertices_of_b;
    for(std::size_t k = 0; k < a_.size && is_usable_; ++k)
      if(doubles.may_be_nearest_of_a(k))
        vertices_of_a.push_back(vector_to(a_.vertices[k]));
    for(std::size_t k = 0; k < b_.size && is_usable_; ++k)
      if(doubles.may_be_nearest_of_b(k))
        vertices_of_b.push_back(vector_to(b_.vertices[k]));
    if(!is_usable_)
      return std::nullopt;
    const auto within = [&](const Int128& n, const Int128& d) {
      return is_open_ ? n < reach_ * reach_ * d : n <= reach_ * reach_ * d;
    };
    return Exact_hull_distance<Int128, Dimension, decltype(within)>(within)(vertices_of_a,
                                                                           vertices_of_b);
  }

private:
  // Differences have at most these bits, and so has the reach. See distance_bits().
  static constexpr int max_bits = Dimension == 2 ? 30 : 20;

  // Both numbers are multiples of the grid, so their difference is a double, if it is small.
  Int128 steps(double x)
  {
    const double steps = std::ldexp(x, -grid_.exponent());
    is_usable_ = is_usable_ && std::fabs(steps) < std::ldexp(1., max_bits - 2);
    return is_usable_ ? static_cast<std::int64_t>(steps) : 0;
  }

  Vector vector_to(const std::array<double, Dimension>& p)
  {
    Vector v;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      v[axis] = steps(p[axis] - a_.vertices[0][axis]);
    return v;
  }

  const Points& a_;
  const Points& b_;
  const bool is_open_;
  bool is_usable_;
  Double_grid grid_;
  Int128 reach_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_HULL_BOUND_H
