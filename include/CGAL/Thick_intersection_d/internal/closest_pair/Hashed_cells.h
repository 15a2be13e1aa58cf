// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_HASHED_CELLS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_HASHED_CELLS_H

// Cells for points whose coordinates are doubles, or are up to an error above doubles. The points
// may be at any distance from the origin. A hash identifies a cell.
//
// The index of a coordinate x is f(x) = x / side, cut to an integer. It is rounded, so cells far
// from the origin are larger than others. The search needs only that f is monotone, as rounding is:
// if x <= y + w in real numbers for a double x, then x <= fl(y + w), and f(x) <= f(fl(y + w)). So
// points within w of y have indices between f(fl(y - w)) and f(fl(y + w)).
//
// From 2^53 sides on, doubles are a side or more apart, and each double has an index of its own:
// the next double has the next index. So whatever the scales of a scene, along each axis a cell is
// at most a few sides long, or holds at most three doubles. In a fixed dimension it holds O(1)
// points that are a side or more apart. A coordinate is within w of O(1) cells, for w of at most a
// side.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The first cell of a point, and whether the point is in other cells as well.
struct First_cell
{
  std::uint64_t hash;
  bool has_others;
};

template <int Dimension>
class Hashed_cells
{
public:
  // Cells for points in a box. Coordinates are up to `error` above the doubles of points, and the
  // error is at most the width.
  Hashed_cells(const std::array<Interval, Dimension>& box, double error, double width, double side,
               std::uint64_t seed)
    : width_(width), width_above_(error == 0 ? width : next_above(width + error)),
      hash_(Dimension, seed)
  {
    constexpr double max_double = (std::numeric_limits<double>::max)();
    if(side < 0x1p-1000) // its inverse may be no double
      prescale_ = 0x1p100;
    scale_ = side <= max_double ? 1 / (side * prescale_) : 0; // longer sides make one cell
    far_ = (std::min)(side * 0x1p53, max_double);
    near_ = prescale_ == 1 ? far_ - 4 * width : 0;
    for(const Interval& interval : box)
      are_near_ = are_near_ && -near_ < interval.low && interval.high < near_;
  }

  // Calls f(hash) for each cell that may hold points within the width of a point along each axis.
  // The doubles of the point are x[i].
  template <class Function>
  void for_each_cell_around(const double* x, const Function& f) const
  {
    visit<0>(are_near_ ? near_ranges_around(x) : ranges_around(x), 0, f);
  }

  // Returns the first of these cells.
  First_cell first_cell_around(const double* x) const { return first_of(ranges_around(x)); }

  // Whether all points are near to the origin, where cells have one size.
  bool are_near() const { return are_near_; }

  // As first_cell_around(), if all points are near.
  First_cell first_near_cell_around(const double* x) const
  {
    return first_of(near_ranges_around(x));
  }

private:
  struct Index_range
  {
    std::int64_t first;
    std::int64_t last;
  };

  First_cell first_of(const std::array<Index_range, Dimension>& ranges) const
  {
    std::uint64_t hash = 0;
    std::int64_t difference = 0;
    for(int axis = 0; axis < Dimension; ++axis) {
      hash = hash_.add(hash, axis, ranges[axis].first);
      difference |= ranges[axis].first ^ ranges[axis].last;
    }
    return {hash_.finish(hash), difference != 0};
  }

  std::int64_t near_index(double x) const { return static_cast<std::int64_t>(x * scale_); }

  // Monotone: products and the conversion, which cuts towards zero, are monotone, and the index of
  // a far double continues from that of far_.
  std::int64_t index(double x) const
  {
    return std::fabs(x) < near_ ? near_index(x) : index_at_any_scale(x);
  }

  // Not inline, so that loops stay short.
  BOOST_NOINLINE std::int64_t index_at_any_scale(double x) const
  {
    const double size = std::fabs(x);
    std::int64_t i
      = static_cast<std::int64_t>((std::min)(size, far_) * prescale_ * scale_);
    if(size > far_)
      i += static_cast<std::int64_t>(radix_key(size) - radix_key(far_));
    return x < 0 ? -i : i;
  }

  std::array<Index_range, Dimension> near_ranges_around(const double* x) const
  {
    std::array<Index_range, Dimension> ranges;
    for(int axis = 0; axis < Dimension; ++axis)
      ranges[axis] = {near_index(x[axis] - width_), near_index(x[axis] + width_above_)};
    return ranges;
  }

  // Not inline, so that loops stay short.
  BOOST_NOINLINE std::array<Index_range, Dimension> ranges_around(const double* x) const
  {
    std::array<Index_range, Dimension> ranges;
    for(int axis = 0; axis < Dimension; ++axis)
      ranges[axis] = {index(x[axis] - width_), index(x[axis] + width_above_)};
    return ranges;
  }

  template <int Axis, class Function>
  void visit(const std::array<Index_range, Dimension>& ranges, std::uint64_t hash,
             const Function& f) const
  {
    if constexpr(Axis == Dimension)
      f(hash_.finish(hash));
    else
      for(std::int64_t i = ranges[Axis].first; i <= ranges[Axis].last; ++i)
        visit<Axis + 1>(ranges, hash_.add(hash, Axis, i), f);
  }

  static double next_above(double x)
  {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
  }

  double width_;
  double width_above_;
  double prescale_ = 1; // a power of two: prescale_ * scale_ is 1 / side
  double scale_ = 0;
  double near_ = 0;      // up to three widths beyond it, near_index() is the index
  double far_ = 0;       // beyond it, each double has an index of its own
  bool are_near_ = true; // the points
  Sequence_hash<Dimension> hash_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_HASHED_CELLS_H
