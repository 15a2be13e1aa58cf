// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_POINTS_H

// Checks the coordinates of all points and makes the scene, in one pass, by blocks.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/check_denormals.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The values of all axes: in an array if the type of the points tells how many axes there are. The
// compiler keeps the values of an array in registers.
template <class Point, class Value>
auto values_of_axes(const std::vector<Value>& values)
{
  if constexpr(constexpr int dimension = dimension_or<Point>(0); dimension != 0) {
    std::array<Value, dimension> array;
    std::copy(values.begin(), values.end(), array.begin());
    return array;
  }
  else
    return values;
}

// What a scan has found about some of the points.
class Scene_scan
{
public:
  // Finds the grid of the coordinates or not: this takes half of the time.
  Scene_scan(int dimension, bool finds_grid)
    : box_(static_cast<std::size_t>(dimension)), finds_grid_(finds_grid), grids_(box_.size())
  {}

  // The position of the first point that is not finite or has another dimension.
  std::size_t first_bad() const { return first_bad_; }

  // Adds the points [first, last), and calls store(position, axis, lower bound) for each
  // coordinate.
  template <class Elements, class Store>
  BOOST_NOINLINE
  void add(const Elements& points, std::size_t first, std::size_t last, const Store& store)
  {
    if(finds_grid_)
      add_points(points, first, last, [&](std::size_t position, int axis, double x) {
        grids_[axis].add(x);
        store(position, axis, x);
      });
    else
      add_points(points, first, last, store);
  }

  // Adds what another scan has found about other points.
  void add(const Scene_scan& other)
  {
    for(std::size_t axis = 0; axis < box_.size(); ++axis) {
      box_[axis].add(other.box_[axis]);
      grids_[axis].add(other.grids_[axis]);
    }
    error_ = (std::max)(error_, other.error_);
    first_bad_ = (std::min)(first_bad_, other.first_bad_);
  }

  // Returns the scene of the points. `size` is their number.
  Scene scene(std::size_t size) const
  {
    Scene scene;
    scene.size = size;
    scene.box = box_;
    if(error_ != 0)
      scene.error = std::nextafter(error_, std::numeric_limits<double>::infinity()); // was rounded
    else if(finds_grid_)
      scene.grid_exponent = scene.exponent_of(grids_);
    return scene;
  }

private:
  // How far ahead the scan asks for lazy points, each of which is memory of its own. Measured.
  static constexpr std::size_t points_ahead = 32;

  template <class Elements, class Store>
  void add_points(const Elements& points, std::size_t first, std::size_t last, const Store& store)
  {
    using Point = typename Elements::value_type;
    const int dimension = dimension_or<Point>(static_cast<int>(box_.size()));
    auto box = values_of_axes<Point>(box_);
    double error = error_;
    for(std::size_t position = first; position < last; ++position) {
      if(position + points_ahead < last)
        prefetch_approximation(points, position + points_ahead);
      const auto& point = points[position];
      bool is_good = dimension_of(point) == dimension;
      for(int axis = 0; is_good && axis < dimension; ++axis) {
        const std::pair<double, double> x = coordinate_bounds(point, axis);
        is_good = are_bounds_of_finite(x);
        box[axis].add(Interval{x.first, x.second});
        if constexpr(!is_held_by_double_v<Coordinate_t<Point>>)
          error = (std::max)(error, x.second - x.first);
        store(position, axis, x.first);
      }
      if(!is_good)
        first_bad_ = (std::min)(first_bad_, position);
    }
    std::copy_n(box.begin(), box_.size(), box_.begin()); // none if there are no points
    error_ = error;
  }

  std::vector<Interval> box_;
  bool finds_grid_;
  std::vector<Double_grid> grids_; // of the lower bounds, per axis
  double error_ = 0;               // the largest difference of two bounds
  std::size_t first_bad_ = (std::numeric_limits<std::size_t>::max)();
};

// Scans the points by several threads.
template <class Elements, class Store>
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
Scene_scan scan_in_blocks(const Elements& points, int dimension, bool finds_grid,
                          const Store& store, const Threads& threads)
{
  Scene_scan all(dimension, finds_grid);
  std::mutex mutex;
  threads.run_numbered_blocks(
    threads.block_count(), points.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      check_denormals(); // in each thread that takes part
      Scene_scan scan(dimension, finds_grid);
      scan.add(points, first, last, store);
      const std::lock_guard<std::mutex> lock(mutex);
      all.add(scan);
    });
  return all;
}

// Makes lazy coordinates exact if their bounds are further apart than `width`.
template <class Elements>
void make_exact(const Elements& points, int dimension, double width)
{
  for(std::size_t position = 0; position < points.size(); ++position) {
    const auto& point = points[position];
    for(int axis = 0; axis < dimension; ++axis) {
      const std::pair<double, double> x = coordinate_bounds(point, axis);
      if(x.second - x.first > width)
        CGAL::exact(coordinate(point, axis));
    }
  }
}

// Returns the scene of the points, and calls store(position, axis, lower bound) for each
// coordinate, perhaps more than once. Throws if a coordinate is NaN or infinite, or if a point has
// another dimension than the first point; messages call a point `name`. Throws if denormal numbers
// are flushed to zero.
//
// A search looks at the pairs within its reach and the error. So a single number that has lost its
// leading bits would bring all pairs near each other: such numbers are made exact.
template <class Elements, class Store>
Scene scan_points(const Elements& points, const char* name, bool finds_grid, const Store& store,
                  const Threads& threads)
{
  const int dimension = points.size() == 0 ? 0 : dimension_of(points[0]);
  const Scene_scan scan = scan_in_blocks(points, dimension, finds_grid, store, threads);
  if(scan.first_bad() < points.size())
    check_point(points[scan.first_bad()], dimension, name, scan.first_bad());
  const Scene scene = scan.scene(points.size());
  if constexpr(Is_lazy<Coordinate_t<typename Elements::value_type>>::value)
    if(const double width = 0x1p-30 * scene.largest_coordinate(); scene.error > width) {
      make_exact(points, dimension, width);
      return scan_in_blocks(points, dimension, finds_grid, store, threads).scene(points.size());
    }
  return scene;
}

template <class Elements>
Scene scan_points(const Elements& points, const char* name, bool finds_grid = true,
                  const Threads& threads = Threads())
{
  return scan_points(points, name, finds_grid, [](std::size_t, int, double) {}, threads);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_SCAN_POINTS_H
