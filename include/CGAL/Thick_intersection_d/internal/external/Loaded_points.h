// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H

// A part in memory.

#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A grid of cells of equal size on the last two axes. The cells of a row of the last axis follow
// each other: slabs are cut along the last axis, and strips along the one before it.
class Part_grid
{
public:
  // For so many points, all in the box. The cache is to hold the ends of all cells.
  Part_grid(const Part_box& box, std::size_t size)
    : rows_(static_cast<std::size_t>((std::min)(std::sqrt(static_cast<double>(size) / 256), 63.))
            + 1),
      slabs_(box.intervals()[2], rows_), strips_(box.intervals()[1], rows_)
  {}

  std::size_t cell_count() const { return rows_ * rows_; }

  std::size_t cell_of(const Stored_point& point) const
  {
    return slabs_.row_of(point.x[2]) * rows_ + strips_.row_of(point.x[1]);
  }

private:
  class Axis
  {
  public:
    Axis(const Interval& interval, std::size_t rows)
      : low_(interval.low), scale_(static_cast<double>(rows) / interval.length()),
        last_(rows - 1)
    {}

    // All rows will do for an interval without length, or one whose length overflows.
    std::size_t row_of(double x) const
    {
      const double row = (x - low_) * scale_;
      return row < static_cast<double>(last_) ? static_cast<std::size_t>(row) : last_;
    }

  private:
    double low_;
    double scale_;
    std::size_t last_;
  };

  std::size_t rows_;
  Axis slabs_;
  Axis strips_;
};

// The points of a part, in the order in which a search sweeps them, roughly: it looks up the id of
// both points of each pair. In the order of the input, these ids are all over the memory, and
// looking them up takes longer than the search.
template <class Point>
struct Loaded_points
{
  std::vector<Point> points;
  std::vector<std::uint64_t> ids;
  std::size_t owned = 0; // the first ones; pairs of the others are found elsewhere

  // The first `owned_count` points are the part's own, with their box.
  Loaded_points(const std::vector<Stored_point>& stored, std::size_t owned_count,
                const Part_box& box)
    : points(stored.size()), ids(stored.size()), owned(owned_count)
  {
    const Part_grid grid(box, owned);
    std::vector<std::size_t> places(grid.cell_count() + 1);
    for(std::size_t i = 0; i < owned; ++i)
      ++places[grid.cell_of(stored[i]) + 1];
    for(std::size_t cell = 0; cell < grid.cell_count(); ++cell)
      places[cell + 1] += places[cell];
    for(std::size_t i = 0; i < owned; ++i)
      put(stored[i], places[grid.cell_of(stored[i])]++);
    for(std::size_t i = owned; i < stored.size(); ++i)
      put(stored[i], i);
  }

private:
  void put(const Stored_point& point, std::size_t place)
  {
    points[place] = Point(point.x[0], point.x[1], point.x[2]);
    ids[place] = point.id;
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
