// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_FRACTIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_FRACTIONS_H

// How many times the vectors of a lattice go into the points of a scene, in doubles with a bound on
// their error. The bound holds in every rounding mode.
//
// All lengths are taken times a power of two that brings the vectors near to 1, so that nothing
// overflows and what underflows is small beside the vectors.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Cell_fractions
{
public:
  CGAL_RARELY_CALLED Cell_fractions(const Lattice_basis<Dimension>& basis, const Scene& scene)
  {
    double largest = 0;
    for(int k = 0; k < basis.rank(); ++k)
      for(const Exact_rational& x : basis.vector(k))
        largest = (std::max)(largest, largest_absolute(x));
    const int exponent = basis.rank() == 0 ? 0 : std::ilogb((std::min)(largest, 0x1p1023));
    scale_ = std::ldexp(1., -(std::max)(-max_exponent, (std::min)(exponent, max_exponent)));
    for(int k = 0; k < basis.rank(); ++k)
      set_vector(k, basis, scene);
  }

  // Returns how many times each vector goes into the point with the coordinates x, up to error(k):
  // zero where there is no vector.
  std::array<double, Dimension> operator()(const std::array<double, Dimension>& x) const
  {
    return fractions(x, std::make_index_sequence<Dimension>());
  }

  double error(int k) const { return errors_[k]; }

  // Returns doubles that enclose how many times vector k goes into the points of the scene.
  const Interval& range(int k) const { return ranges_[k]; }

  // Returns an upper bound on how many times vector k goes into a vector of length `reach`.
  double fraction_of(int k, double reach) const
  {
    return reach * scale_ * lengths_[k] * (1 + rounding) + rounding;
  }

  // Returns the axis of vector k, or -1 if it is along none.
  int axis_of(int k) const
  {
    int axis = -1;
    for(int i = 0; i < Dimension; ++i)
      if(duals_[k][i] != 0) {
        if(axis >= 0)
          return -1;
        axis = i;
      }
    return axis;
  }

  // Returns the coordinates along axis_of(k) into which vector k goes between `low` and `high`
  // times, also as operator() rounds it, but for a few at both ends. Scaling is exact, unless it
  // overflows, when no coordinate is as large, or underflows.
  Interval coordinates_between(int k, double low, double high) const
  {
    const double dual = duals_[k][axis_of(k)];
    if(dual < 0)
      std::swap(low, high);
    const double first = low / dual / scale_, last = high / dual / scale_;
    const double margin = rounding * (std::fabs(first) + std::fabs(last)
                                      + 1 / std::fabs(dual) / scale_) + 0x1p-1000;
    return {first + margin, last - margin};
  }

private:
  // Without loops, which take the compiler's code three times as long.
  template <std::size_t... I>
  std::array<double, Dimension> fractions(const std::array<double, Dimension>& x,
                                          std::index_sequence<I...> axes) const
  {
    const std::array<double, Dimension> scaled = {(x[I] * scale_)...};
    return {product(duals_[I], scaled, axes)...};
  }
  template <std::size_t... I>
  static double product(const std::array<double, Dimension>& v,
                        const std::array<double, Dimension>& w, std::index_sequence<I...>)
  {
    return ((v[I] * w[I]) + ...);
  }

  static constexpr int max_exponent = 1000;
  static constexpr double rounding = 0x1p-45; // of a few operations, with room to spare

  static double largest_absolute(const Exact_rational& x)
  {
    const auto [low, high] = bounds(x);
    return (std::max)(-low, high);
  }

  // A product of two numbers has a relative error of 2^-52 at most, as has the dual vector and each
  // sum; what underflows is below the smallest normal number.
  void set_vector(int k, const Lattice_basis<Dimension>& basis, const Scene& scene)
  {
    const Exact_rational unit(1 / scale_);
    const auto square = bounds(
      Exact_rational(basis.product(basis.dual(k), basis.dual(k)) * unit * unit));
    lengths_[k] = std::sqrt(square.second) * (1 + rounding);
    double error = 0x1p-900;
    for(int axis = 0; axis < Dimension; ++axis) {
      const Interval& interval = scene.box[axis];
      const double dual = bounds(Exact_rational(basis.dual(k)[axis] * unit)).first;
      const double low = interval.low * scale_ * dual, high = interval.high * scale_ * dual;
      duals_[k][axis] = dual;
      ranges_[k].low += (std::min)(low, high);
      ranges_[k].high += (std::max)(low, high);
      const double largest = (std::max)(-interval.low, interval.high) * scale_ + 0x1p-900;
      error += std::fabs(dual) * (largest * rounding + scene.error * scale_ * (1 + rounding));
    }
    if(!std::isfinite(lengths_[k]) || !std::isfinite(error))
      throw std::length_error("The periods are too short beside other periods or the points.");
    errors_[k] = error;
    ranges_[k] = {ranges_[k].low - error, ranges_[k].high + error};
  }

  double scale_;
  std::array<std::array<double, Dimension>, Dimension> duals_ = {};
  std::array<double, Dimension> lengths_ = {}; // of the dual vectors
  std::array<double, Dimension> errors_ = {};
  std::array<Interval, Dimension> ranges_ = zero_intervals();

  static std::array<Interval, Dimension> zero_intervals()
  {
    std::array<Interval, Dimension> intervals;
    intervals.fill({0, 0});
    return intervals;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_FRACTIONS_H
