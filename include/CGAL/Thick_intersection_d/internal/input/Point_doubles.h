// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H

// Where the slab route reads the doubles of points.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The coordinates of points, if they are doubles: read where they are.
template <class Elements>
class Held_doubles
{
public:
  explicit Held_doubles(const Elements& points) : points_(points) {}

  void set(std::size_t, int, double) {}
  void share(int, double) {}

  // Asks for the memory of a point.
  void ask_for([[maybe_unused]] std::size_t position) const
  {
    if constexpr(std::is_lvalue_reference_v<decltype(points_[position])>)
      prefetch_to_read(std::addressof(points_[position]));
  }

  double at(std::size_t position, int axis) const
  {
    return static_cast<double>(coordinate(points_[position], axis));
  }

  template <int Dimension>
  std::array<double, Dimension> at(std::size_t position) const
  {
    const auto& point = points_[position];
    std::array<double, Dimension> x;
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = static_cast<double>(coordinate(point, axis));
    return x;
  }

private:
  const Elements& points_;
};

// Lower bounds of coordinates of other types, computed once, with a column per axis. There are no
// columns if the dimension is not for the slab route.
template <class Elements>
class Copied_doubles
{
public:
  explicit Copied_doubles(const Elements& points)
  {
    const int dimension = points.size() == 0 ? 0 : points[0].dimension();
    if(dimension == 2 || dimension == 3)
      for(int axis = 0; axis < dimension; ++axis)
        columns_.push_back(make_uninitialized<double>(points.size()));
  }

  void set(std::size_t position, int axis, double x)
  {
    if(!columns_.empty())
      columns_[static_cast<std::size_t>(axis)][position] = x;
  }

  void ask_for(std::size_t position) const
  {
    for(const auto& column : columns_)
      if(column)
        prefetch_to_read(column.get() + position);
  }

  // Forgets the column of an axis along which all points have the coordinate x.
  void share(int axis, double x)
  {
    columns_[static_cast<std::size_t>(axis)].reset();
    shared_[static_cast<std::size_t>(axis)] = x;
  }

  double at(std::size_t position, int axis) const
  {
    const auto& column = columns_[static_cast<std::size_t>(axis)];
    return column ? column[position] : shared_[static_cast<std::size_t>(axis)];
  }

  template <int Dimension>
  std::array<double, Dimension> at(std::size_t position) const
  {
    std::array<double, Dimension> x;
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = at(position, axis);
    return x;
  }

private:
  std::vector<std::unique_ptr<double[]>> columns_;
  std::array<double, 3> shared_ = {};
};

template <class Elements>
using Doubles = std::conditional_t<is_held_by_double_v<Coordinate_t<typename Elements::value_type>>,
                                   Held_doubles<Elements>, Copied_doubles<Elements>>;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H
