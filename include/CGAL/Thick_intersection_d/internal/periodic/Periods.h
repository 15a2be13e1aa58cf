// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODS_H

// The periods of a domain, as exact vectors. An offset moves a point by an integer multiple of each
// period. A moved coordinate is never rounded: it is an exact number, with doubles around it.

#include <CGAL/Periodic_lattice_d.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <ios>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns a count that may be too large for an integer, in the words of a message.
inline std::string count_text(double count)
{
  std::ostringstream text;
  if(count < 0x1p53)
    text << std::fixed;
  text.precision(count < 0x1p53 ? 0 : 3);
  text << count;
  return text.str();
}

// How many times each period is added.
template <int Dimension>
using Offset = std::array<int, static_cast<std::size_t>(Dimension)>;

// Returns the offset b - a, from the image that a moves to the image that b moves.
template <std::size_t Dimension>
std::array<int, Dimension> offset_between(const std::array<int, Dimension>& a,
                                          const std::array<int, Dimension>& b)
{
  std::array<int, Dimension> result;
  std::transform(b.begin(), b.end(), a.begin(), result.begin(), std::minus<int>());
  return result;
}

template <class Domain>
inline constexpr bool is_lattice_v = false;
template <class Vector>
inline constexpr bool is_lattice_v<Periodic_lattice_d<Vector>> = true;

// The lattice of a domain, which is a lattice or an iso-box.
template <class Domain>
auto lattice_of(const Domain& domain)
{
  if constexpr(is_lattice_v<Domain>)
    return domain;
  else
    return Periodic_lattice_d(domain);
}

// A type for sums of numbers of both types, without error.
template <class NT, class Other>
using Common_exact_t
  = std::conditional_t<std::is_same_v<Exact_number_t<NT>, Exact_number_t<Other>>,
                       Exact_number_t<NT>, Exact_rational>;

template <int Dimension, class Exact_>
class Periods
{
public:
  using Exact = Exact_;

  // Throws if a component is NaN or infinite.
  template <class Vector>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  explicit Periods(const Periodic_lattice_d<Vector>& lattice)
  {
    for(int k = 0; k < Dimension; ++k) {
      for(int axis = 0; axis < Dimension; ++axis) {
        const auto& [from, to] = lattice.ends(k, axis);
        if(!is_finite_number(from) || !is_finite_number(to))
          throw std::invalid_argument("A period is NaN or infinite.");
        vectors_[k][axis] = to_exact<Exact>(to) - to_exact<Exact>(from);
        moves_[k][axis] = lattice.repeats(k) && vectors_[k][axis] != Exact(0);
        if(moves_[k][axis]) {
          const auto [low, high] = tight_bounds(vectors_[k][axis]);
          steps_[k][axis] = low == high ? low : std::numeric_limits<double>::quiet_NaN();
        }
      }
    }
  }

  // Returns x, a coordinate along an axis, moved by an offset.
  template <class NT>
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED
  Exact moved(const NT& x, const Offset<Dimension>& offset, int axis) const
  {
    Exact sum(to_exact<Exact>(x));
    for(int k = 0; k < Dimension; ++k)
      if(offset[k] != 0 && moves_[k][axis])
        sum += Exact(static_cast<double>(offset[k])) * vectors_[k][axis];
    return sum;
  }

  // Returns doubles that enclose the sum. If the coordinates of points are doubles, they are equal
  // iff the sum is a double. Most points are moved by one period, and most periods are doubles.
  template <class Point>
  std::pair<double, double> moved_bounds(const Point& p, const Offset<Dimension>& offset,
                                         int axis) const
  {
    double y = 0; // exact if one period is added at most
    std::int64_t count = 0;
    for(int k = 0; k < Dimension; ++k) {
      y += offset[k] * steps_[k][axis];
      count += moves_[k][axis] ? std::abs(offset[k]) : 0;
    }
    if(count == 0)
      return coordinate_bounds(p, axis);
    if(count == 1) {
      const std::pair<double, double> sum = enclosed_sum(coordinate_bounds(p, axis), y);
      if(std::isfinite(sum.first) && std::isfinite(sum.second))
        return sum;
    }
    return tight_bounds(moved(coordinate(p, axis), offset, axis));
  }

private:
  // The bounds of an exact number may be two doubles, one of which is the number itself.
  static std::pair<double, double> tight_bounds(const Exact& x)
  {
    const std::pair<double, double> enclosing = bounds(x);
    for(const double y : {enclosing.first, enclosing.second})
      if(std::isfinite(y) && Exact(y) == x)
        return {y, y};
    return enclosing;
  }

  // The error of a computed sum is less than one unit in its last place, in every rounding mode.
  static std::pair<double, double> enclosed_sum(const std::pair<double, double>& x, double y)
  {
    const double low = x.first + y, high = x.second + y;
    return {low - error_of_sum(low, x.first, y), high + error_of_sum(high, x.second, y)};
  }

  // Returns zero if s, the computed sum x + y, is not rounded: without a jump, which no processor
  // could foresee. The difference of s and the number of larger absolute value is exact, in every
  // rounding mode.
  static double error_of_sum(double s, double x, double y)
  {
    constexpr std::array<double, 2> relative_errors = {0x1p-52, 0};
    const bool is_exact = (s - x == y) & (s - y == x);
    return std::fabs(s) * relative_errors[is_exact];
  }

  std::array<std::array<Exact, Dimension>, Dimension> vectors_;
  std::array<std::array<double, Dimension>, Dimension> steps_ = {}; // NaN if no doubles
  std::array<std::array<bool, Dimension>, Dimension> moves_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_PERIODS_H
