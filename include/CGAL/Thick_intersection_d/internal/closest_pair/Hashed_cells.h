// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_HASHED_CELLS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_HASHED_CELLS_H

// Cells for points whose coordinates are doubles, or are enclosed by doubles. The points may be at
// any distance from the origin. A hash identifies a cell.
//
// The index of a coordinate x is f(x) = x / side, cut to an integer. It is rounded, so cells far
// from the origin are larger than others. The search needs only that f is monotone, as rounding is:
// if x <= y + w in real numbers for a double x, then x <= fl(y + w), and f(x) <= f(fl(y + w)). So
// points within w of y have indices between f(fl(y - w)) and f(fl(y + w)).

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Dimension` is the dimension of the points, or 0 if it is known at run time only.
template <int Dimension>
class Hashed_cells
{
public:
  // Whether cells of about the size of `reach` are useful. The inverse of a side is a double, and a
  // coordinate between doubles that are `error` apart is in few cells.
  static bool fits(double reach, double error)
  {
    return reach >= 0x1p-900 && reach <= 0x1p900 && error <= reach / 2;
  }

  Hashed_cells() = default;
  Hashed_cells(int dimension, double width, double side)
    : dimension_(dimension), width_(width), scale_(1 / side)
  {}

  // Returns the hash of the cell that holds the lower bounds of the coordinates of p.
  template <class Point>
  std::uint64_t cell_of(const Point& p) const
  {
    std::uint64_t hash = 0;
    for(int axis = 0; axis < dimension(); ++axis)
      hash = add_to_hash(hash, index(coordinate_bounds(p, axis).first));
    return finish_hash(hash);
  }

  // Calls f(hash) for each cell that may hold points within the width of p along each axis.
  template <class Point, class Function>
  void for_each_cell_around(const Point& p, const Function& f) const
  {
    if constexpr(Dimension == 0)
      visit(p, 0, 0, f);
    else
      visit<0>(ranges_around(p), 0, f);
  }

  // Returns the hash of the first of these cells, and whether there are more.
  template <class Point>
  std::pair<std::uint64_t, bool> first_cell_around(const Point& p) const
  {
    const auto ranges = ranges_around(p);
    std::uint64_t hash = 0;
    std::int64_t difference = 0;
    for(int axis = 0; axis < Dimension; ++axis) {
      hash = add_to_hash(hash, ranges[axis].first);
      difference |= ranges[axis].first ^ ranges[axis].last;
    }
    return {finish_hash(hash), difference != 0};
  }

private:
  struct Index_range
  {
    std::int64_t first;
    std::int64_t last;
  };

  int dimension() const { return Dimension == 0 ? dimension_ : Dimension; }

  // Monotone: the product, the limits, and the conversion, which cuts towards zero, are monotone.
  std::int64_t index(double x) const
  {
    constexpr double limit = 0x1p62;
    return static_cast<std::int64_t>((std::max)(-limit, (std::min)(x * scale_, limit)));
  }

  template <class Point>
  Index_range index_range(const Point& p, int axis) const
  {
    const std::pair<double, double> x = coordinate_bounds(p, axis);
    return {index(x.first - width_), index(x.second + width_)};
  }

  template <class Point>
  std::array<Index_range, Dimension> ranges_around(const Point& p) const
  {
    std::array<Index_range, Dimension> ranges;
    for(int axis = 0; axis < Dimension; ++axis)
      ranges[axis] = index_range(p, axis);
    return ranges;
  }

  template <class Point, class Function>
  void visit(const Point& p, int axis, std::uint64_t hash, const Function& f) const
  {
    if(axis == dimension_) {
      f(finish_hash(hash));
      return;
    }
    const Index_range range = index_range(p, axis);
    for(std::int64_t i = range.first; i <= range.last; ++i)
      visit(p, axis + 1, add_to_hash(hash, i), f);
  }

  template <int Axis, class Function>
  static void visit(const std::array<Index_range, Dimension>& ranges, std::uint64_t hash,
                    const Function& f)
  {
    if constexpr(Axis == Dimension)
      f(finish_hash(hash));
    else
      for(std::int64_t i = ranges[Axis].first; i <= ranges[Axis].last; ++i)
        visit<Axis + 1>(ranges, add_to_hash(hash, i), f);
  }

  int dimension_ = Dimension;
  double width_ = 0;
  double scale_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_HASHED_CELLS_H
