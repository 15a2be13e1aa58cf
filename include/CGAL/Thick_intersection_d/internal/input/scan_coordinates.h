// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_COORDINATES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_COORDINATES_H

// One pass over the coordinates of all points, by blocks: checks them, and finds what a profile and
// a search want to know.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Coordinate_scan
{
  explicit Coordinate_scan(int dimension)
    : box(static_cast<std::size_t>(dimension), {std::numeric_limits<double>::infinity(),
                                                -std::numeric_limits<double>::infinity()}),
      grids(box.size())
  {}

  // Whether the points differ along an axis; if not, all their coordinates are the same double.
  bool is_extended_along(std::size_t axis) const { return box[axis].first < box[axis].second; }

  // Whether all coordinates are doubles, whatever their type.
  bool are_doubles() const { return error == 0; }

  // The exponent of the coarsest grid that holds all coordinates but those that are the same for
  // all points, or nothing if they are not doubles.
  std::optional<int> grid_exponent() const
  {
    if(!are_doubles())
      return std::nullopt;
    Grid_scan grid;
    for(std::size_t i = 0; i < box.size(); ++i)
      if(is_extended_along(i))
        grid.add(grids[i]);
    return grid.exponent();
  }

  std::vector<std::pair<double, double>> box; // rounded outwards
  std::vector<Grid_scan> grids;               // of the lower bounds, per axis
  double error = 0;                           // the greatest distance of two bounds
  std::size_t first_bad = (std::numeric_limits<std::size_t>::max)(); // position

  void add(const Coordinate_scan& other)
  {
    for(std::size_t i = 0; i < box.size(); ++i) {
      box[i].first = (std::min)(box[i].first, other.box[i].first);
      box[i].second = (std::max)(box[i].second, other.box[i].second);
      grids[i].add(other.grids[i]);
    }
    error = (std::max)(error, other.error);
    first_bad = (std::min)(first_bad, other.first_bad);
  }
};

// Adds the points [first, last) to `scan`, and calls store(position, axis, lower bound).
template <class Elements, class Store>
void scan_block(const Elements& points, std::size_t first, std::size_t last, int dimension,
                Coordinate_scan& scan, const Store& store)
{
  using Number = Coordinate_t<typename Elements::value_type>;
  for(std::size_t position = first; position < last; ++position) {
    const auto& point = points[position];
    bool is_good = point.dimension() == dimension;
    for(int i = 0; is_good && i < dimension; ++i) {
      const std::pair<double, double> x = coordinate_bounds(point, i);
      is_good = are_bounds_of_finite(x);
      scan.box[i].first = (std::min)(scan.box[i].first, x.first);
      scan.box[i].second = (std::max)(scan.box[i].second, x.second);
      scan.grids[i].add(x.first);
      if constexpr(!is_held_by_double_v<Number>)
        scan.error = (std::max)(scan.error, x.second - x.first);
      store(position, i, x.first);
    }
    if(!is_good) {
      scan.first_bad = position;
      return;
    }
  }
}

// Throws if a point, called `name` in the message, has a NaN or infinite coordinate or another
// dimension than the first one, or if denormal numbers are flushed to zero.
template <class ConcurrencyTag, class Elements, class Store>
Coordinate_scan scan_coordinates(const Elements& points, const std::string& name,
                                 const Store& store)
{
  const int dimension = points.size() == 0 ? 0 : points[0].dimension();
  Coordinate_scan scan(dimension);
  std::vector<Coordinate_scan> scans(block_count<ConcurrencyTag>(), scan);
  for_each_numbered_block<ConcurrencyTag>(
    scans.size(), points.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
      check_denormals(); // in each thread that takes part
      scan_block(points, first, last, dimension, scans[block], store);
    });
  for(const Coordinate_scan& each : scans)
    scan.add(each);
  if(scan.first_bad < points.size())
    check_point(points[scan.first_bad], dimension, name, scan.first_bad);
  return scan;
}

template <class ConcurrencyTag, class Elements>
Coordinate_scan scan_coordinates(const Elements& points, const std::string& name)
{
  return scan_coordinates<ConcurrencyTag>(points, name, [](std::size_t, int, double) {});
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_COORDINATES_H
