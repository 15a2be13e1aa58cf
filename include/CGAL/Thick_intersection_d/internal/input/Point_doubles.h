// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H

// The doubles of points: of few points on the stack, of many points as the slab route reads them.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Slabs and cells are faster for more points.
inline constexpr std::size_t max_few_points = 256;

// Whether doubles hold all coordinates of points in the plane or in space, as their type tells.
template <class Point>
constexpr bool has_few_doubles()
{
  if constexpr(dimension_or<Point>(0) == 2 || dimension_or<Point>(0) == 3)
    return is_held_by_double_v<Coordinate_t<Point>>;
  else
    return false;
}

// A column for each axis. Places that nothing was written to have no value.
template <class Point, std::size_t size>
using Few_coordinates = std::array<std::array<double, size>, dimension_or<Point>(0)>;

// Writes the coordinates of the points [first, last) to places from `place` on. Returns false if
// one of them is NaN or infinite.
template <class Elements, class Columns>
bool read_coordinates(const Elements& points, std::size_t first, std::size_t last, Columns& x,
                      std::size_t place)
{
  bool are_finite = true;
  for(; first < last; ++first, ++place) {
    const auto& point = points[first];
    for(std::size_t axis = 0; axis < x.size(); ++axis) {
      const double value = static_cast<double>(coordinate(point, static_cast<int>(axis)));
      are_finite &= std::fabs(value) <= (std::numeric_limits<double>::max)();
      x[axis][place] = value;
    }
  }
  return are_finite;
}

// Returns the squared distance of the points at two places, as doubles compute it.
template <class Columns>
double computed_square(const Columns& x, std::size_t i, std::size_t j)
{
  double sum = 0;
  for(const auto& column : x)
    sum += (column[i] - column[j]) * (column[i] - column[j]);
  return sum;
}

// The doubles that stand for the coordinates of points. Coordinates that are doubles are read where
// they are. Of others, lower bounds are computed once, with a column per axis. There are no columns
// if the dimension is not for the slab route.
template <class Elements>
class Doubles
{
  static constexpr bool are_held = is_held_by_double_v<Coordinate_t<typename Elements::value_type>>;

public:
  explicit Doubles(const Elements& points)
  {
    const int dimension = are_held || points.size() == 0 ? 0 : dimension_of(points[0]);
    if(dimension == 2 || dimension == 3)
      for(int axis = 0; axis < dimension; ++axis)
        columns_.push_back(make_uninitialized<double>(points.size()));
  }

  void set([[maybe_unused]] std::size_t position, [[maybe_unused]] int axis,
           [[maybe_unused]] double x)
  {
    if constexpr(!are_held)
      if(!columns_.empty())
        columns_[static_cast<std::size_t>(axis)][position] = x;
  }

  // Forgets the column of an axis along which all points have the coordinate x.
  void share([[maybe_unused]] int axis, [[maybe_unused]] double x)
  {
    if constexpr(!are_held) {
      columns_[static_cast<std::size_t>(axis)].reset();
      shared_[static_cast<std::size_t>(axis)] = x;
    }
  }

  // Returns where the doubles of an axis are, and how many bytes they are apart. Doubles that are
  // held have no columns.
  std::pair<const double*, std::ptrdiff_t> column(int axis) const
  {
    const auto& column = columns_[static_cast<std::size_t>(axis)];
    if(column)
      return {column.get(), static_cast<std::ptrdiff_t>(sizeof(double))};
    return {&shared_[static_cast<std::size_t>(axis)], 0};
  }

private:
  std::vector<std::unique_ptr<double[]>> columns_; // none of doubles that are held
  std::array<double, 3> shared_ = {};
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H
