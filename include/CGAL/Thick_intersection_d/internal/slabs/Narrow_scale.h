// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NARROW_SCALE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NARROW_SCALE_H

// Coordinates as 32-bit integers: all that the slabs need to tell near points from far ones, in
// half the memory of doubles. They leave a few pairs undecided, which the coordinates themselves
// decide; or none, on a grid whose steps fit. doc/arithmetic.md has the proof of the bounds.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Narrow_scale
{
  using Box = std::array<Interval, Dimension>;

public:
  Narrow_scale() = default; // is not usable

  // Takes the box of some doubles, and the filter for their squared distances. A coordinate x
  // becomes the integer below (x - low) * scale. Rounding moves the difference of two coordinates
  // by less than 1 + 2^-20, and the distance of two points by less than sqrt(d) times as much.
  // Floats compute its square with an error below 2^-20 of it.
  Narrow_scale(const Box& box, const Distance_filter& filter)
  {
    const double inside = std::sqrt(filter.inside) * (1 - relative_slack); // NaN if it is negative
    const double outside = std::sqrt(filter.outside) * (1 + relative_slack);
    const double extent = extent_of(box);
    const double scale = (std::min)((max_narrow_coordinate - margin) / extent,
                                    (max_narrow_reach - margin) / outside);
    if(!(inside * scale >= min_reach) || !std::isnormal(scale) || !std::isnormal(extent))
      return;
    const double slack = std::sqrt(Dimension) * (1 + 0x1p-18);
    set(box, scale);
    question_.inside = static_cast<float>(squared(inside * scale - slack) * (1 - relative_slack));
    question_.outside = static_cast<float>(squared(outside * scale + slack) * (1 + relative_slack));
    question_.reach = static_cast<std::int32_t>(
      (outside * scale + slack) * (1 + 2 * relative_slack) + 2);
    CGAL_assertion(question_.reach <= max_narrow_reach);
  }

  // Takes the box of some doubles on the grid 2^e Z, the reach in steps, rounded down, and the
  // least number of squared steps that is beyond the bound. A coordinate becomes its number of
  // steps from the lower end, without error.
  // Floats compute squared distances within the bound without error if they have 24 bits.
  // Beyond these exponents the scale may overflow, or a difference of coordinates. The result would
  // be finite in some rounding modes.
  Narrow_scale(const Box& box, int grid_exponent, double steps, std::uint64_t first_beyond)
    : max_square_(first_beyond - 1)
  {
    const double scale = std::ldexp(1., -grid_exponent);
    if(grid_exponent < -1023 || grid_exponent > 992
       || !(extent_of(box) * scale <= max_narrow_coordinate)
       || !(steps <= max_narrow_reach / 2) || first_beyond == 0)
      return;
    set(box, scale);
    is_exact_ = true;
    const double square = static_cast<double>(max_square_);
    const double slack = max_square_ < std::uint64_t(1) << 24 ? 0 : relative_slack;
    question_.inside = static_cast<float>(square * (1 - slack));
    question_.outside = static_cast<float>(square * (1 + slack));
    question_.reach = static_cast<std::int32_t>(steps);
  }

  bool is_usable() const { return scale_ > 0; }

  // Whether the integers decide all pairs that the question leaves undecided.
  bool is_exact() const { return is_exact_; }

  const Near_question<std::int32_t>& question() const { return question_; }

  // The lower ends of the axes, and how many steps of the scale a unit has, for To_number.
  const std::array<double, Dimension>& low() const { return low_; }
  double steps() const { return scale_; }

  // Whether points of a squared distance are within the bound. \pre is_exact()
  bool holds_for(std::uint64_t square) const { return square <= max_square_; }

private:
  // Far above the error of doubles; floats have a relative error of at most 2^-23 per operation, in
  // all rounding modes, and there are six of them.
  static constexpr double relative_slack = 0x1p-20;
  // More than rounding, the slack and the relative slack of the largest reach take.
  static constexpr double margin = 256;
  // With a shorter reach, in units, more than a few pairs would be undecided.
  static constexpr double min_reach = 512;

  static double squared(double x) { return x * x; }

  static double extent_of(const Box& box)
  {
    double extent = 0;
    for(const Interval& interval : box)
      extent = (std::max)(extent, interval.length());
    return extent;
  }

  void set(const Box& box, double scale)
  {
    scale_ = scale;
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      low_[axis] = box[axis].low;
  }

  double scale_ = 0;
  std::array<double, Dimension> low_ = {};
  bool is_exact_ = false;
  std::uint64_t max_square_ = 0;
  Near_question<std::int32_t> question_ = {0, -1, -1};
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NARROW_SCALE_H
