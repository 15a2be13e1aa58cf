// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_FRACTIONS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_FRACTIONS_H

// How many times the vectors of a lattice go into the points of a scene, counted from a place among
// them, in doubles with a bound on their error. The bound holds in every rounding mode, wherever
// the scene lies.
//
// All lengths are taken times a power of two that brings the vectors near to 1, so that nothing
// overflows and what underflows is small beside the vectors.
//
// Let x be the difference of a point and the place, as it is computed, d a dual vector, and e the
// distance of the doubles around a coordinate. The difference, the dual vector, each product and
// each of the sums has a relative error of 2^-52 at most. So the sum of the products is off by less
// than 2^-49 times the sum of all |d_i x_i|, and by the sum of all |d_i| e. The bound has 2^-45 in
// the place of 2^-49, for the few operations on fractions that follow, and for its own rounding.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/vectors.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Lattice_basis.h>
#include <CGAL/Thick_intersection_d/internal/periodic/Local_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Cell_fractions
{
  using Vector = std::array<double, Dimension>;

public:
  template <class Elements>
  Cell_fractions(const Threads& threads, const Lattice_basis<Dimension>& basis,
                 const Elements& points, const Scene& scene)
    : rank_(basis.rank()), local_(scene)
  {
    set_scale(basis);
    for(int k = 0; k < rank_; ++k)
      set_vector(k, basis);
    if constexpr(!is_held_by_double_v<Coordinate_t<typename Elements::value_type>>)
      if(are_doubles_far_apart())
        local_.subtract_exactly(points);
    for(int k = 0; k < rank_; ++k)
      set_error_and_range(k);
    if(!are_along_axes())
      set_ranges(threads, points);
  }

  // Returns how many times each vector goes into a point, up to error(k): zero where there is no
  // vector.
  template <class Point>
  Vector operator()(const Point& point) const
  {
    return fractions(local_(point), std::make_index_sequence<Dimension>());
  }

  double error(int k) const { return errors_[k]; }

  // Returns doubles that enclose how many times vector k goes into the points of the scene.
  const Interval& range(int k) const { return ranges_[k]; }

  // Returns an upper bound on how many times vector k goes into a vector of length `reach`.
  double fraction_of(int k, double reach) const
  {
    return reach * scale_ * lengths_[k] * (1 + rounding) + rounding;
  }

  // Whether each vector is along an axis, and the doubles that are read of coordinates tell how
  // often it goes into points. If so, coordinates_between() tells where that is.
  bool have_coordinates() const { return are_along_axes() && !local_.is_exact(); }

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
    const int axis = axis_of(k);
    const double dual = duals_[k][axis];
    if(dual < 0)
      std::swap(low, high);
    const double first = low / dual / scale_, last = high / dual / scale_;
    const double margin = rounding * (std::fabs(first) + std::fabs(last)
                                      + 1 / std::fabs(dual) / scale_) + 0x1p-1000;
    const double begin = local_.place(axis) + (first + margin);
    const double end = local_.place(axis) + (last - margin);
    return {begin + rounding_of_sum * std::fabs(begin), end - rounding_of_sum * std::fabs(end)};
  }

private:
  // Without loops, which take the compiler's code three times as long.
  template <std::size_t... I>
  Vector fractions(const Vector& x, std::index_sequence<I...> axes) const
  {
    const Vector scaled = {(x[I] * scale_)...};
    return {product(duals_[I], scaled, axes)...};
  }
  template <std::size_t... I>
  static double product(const Vector& v, const Vector& w, std::index_sequence<I...>)
  {
    return ((v[I] * w[I]) + ...);
  }

  static constexpr int max_exponent = 1000;
  static constexpr double rounding = 0x1p-45; // of a few operations, with room to spare
  static constexpr double rounding_of_sum = 0x1p-50;

  static double largest_absolute(const Exact_rational& x)
  {
    const auto [low, high] = bounds(x);
    return (std::max)(-low, high);
  }

  void set_scale(const Lattice_basis<Dimension>& basis)
  {
    double largest = 0;
    for(int k = 0; k < rank_; ++k)
      for(const Exact_rational& x : basis.vector(k))
        largest = (std::max)(largest, largest_absolute(x));
    const int exponent = rank_ == 0 ? 0 : std::ilogb((std::min)(largest, 0x1p1023));
    scale_ = std::ldexp(1., -(std::max)(-max_exponent, (std::min)(exponent, max_exponent)));
  }

  void set_vector(int k, const Lattice_basis<Dimension>& basis)
  {
    const Exact_rational unit(1 / scale_);
    const auto square = bounds(
      Exact_rational(dot_product(basis.dual(k), basis.dual(k)) * unit * unit));
    lengths_[k] = std::sqrt(square.second) * (1 + rounding);
    for(int axis = 0; axis < Dimension; ++axis)
      duals_[k][axis] = bounds(Exact_rational(basis.dual(k)[axis] * unit)).first;
  }

  bool are_along_axes() const
  {
    for(int k = 0; k < rank_; ++k)
      if(axis_of(k) < 0)
        return false;
    return true;
  }

  // Whether the doubles around a coordinate are so far apart, beside the periods, that a search by
  // them would take images that the coordinates themselves do not ask for.
  bool are_doubles_far_apart() const
  {
    for(int k = 0; k < rank_; ++k)
      for(const double dual : duals_[k])
        if(!(std::fabs(dual) * local_.error() * scale_ < 0x1p-20))
          return true;
    return false;
  }

  // The differences are as in the box of the scene. What underflows is below the smallest normal
  // number.
  void set_error_and_range(int k)
  {
    double error = 0x1p-900;
    ranges_[k] = {0, 0};
    for(int axis = 0; axis < Dimension; ++axis) {
      const Interval& interval = local_.interval(axis);
      const double dual = duals_[k][axis];
      const double low = interval.low * scale_ * dual, high = interval.high * scale_ * dual;
      ranges_[k].low += (std::min)(low, high);
      ranges_[k].high += (std::max)(low, high);
      const double largest = (std::max)(-interval.low, interval.high) * scale_ + 0x1p-900;
      error += std::fabs(dual) * (largest * rounding + local_.error() * scale_ * (1 + rounding));
    }
    if(!std::isfinite(lengths_[k]) || !std::isfinite(error))
      throw std::length_error("The periods are too short beside other periods or the points.");
    errors_[k] = error;
    ranges_[k] = {ranges_[k].low - error, ranges_[k].high + error};
  }

  // Skewed vectors go into the corners of the box of the scene more often than into the points.
  template <class Elements>
  void set_ranges(const Threads& threads, const Elements& points)
  {
    using Ranges = std::array<Interval, Dimension>;
    std::vector<Ranges> found(threads.block_count());
    threads.run_numbered_blocks(
      found.size(), points.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
        Ranges ranges;
        for(; first < last; ++first) {
          const Vector f = (*this)(points[first]);
          for(int k = 0; k < Dimension; ++k)
            ranges[k].add(f[k]);
        }
        found[block] = ranges;
      });
    for(int k = 0; k < rank_; ++k) {
      Interval range;
      for(const Ranges& part : found)
        range.add(part[k]);
      ranges_[k] = {range.low - errors_[k], range.high + errors_[k]};
    }
  }

  int rank_;
  Local_coordinates<Dimension> local_;
  double scale_ = 1;
  std::array<Vector, Dimension> duals_ = {};
  Vector lengths_ = {}; // of the dual vectors
  Vector errors_ = {};
  std::array<Interval, Dimension> ranges_; // where there is a vector
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_CELL_FRACTIONS_H
