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

#include <algorithm>
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

  // Asks for the memory of a point.
  void ask_for([[maybe_unused]] std::size_t position) const
  {
    if constexpr(std::is_lvalue_reference_v<decltype(points_[position])>)
      prefetch_to_read(std::addressof(points_[position]));
  }


  template <std::size_t Dimension>
  void keep(const std::array<int, Dimension>&) {}

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
      prefetch_to_read(column.get() + position);
  }

  // Forgets the coordinates along other axes.
  template <std::size_t Dimension>
  void keep(const std::array<int, Dimension>& axes)
  {
    for(std::size_t axis = 0; axis < columns_.size(); ++axis)
      if(std::find(axes.begin(), axes.end(), static_cast<int>(axis)) == axes.end())
        columns_[axis].reset();
  }

  double at(std::size_t position, int axis) const
  {
    return columns_[static_cast<std::size_t>(axis)][position];
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
};

template <class Elements>
using Doubles = std::conditional_t<is_held_by_double_v<Coordinate_t<typename Elements::value_type>>,
                                   Held_doubles<Elements>, Copied_doubles<Elements>>;

// The doubles of points along some of their axes.
template <int Dimension, class All_doubles>
class Doubles_along_axes
{
public:
  Doubles_along_axes(const All_doubles& doubles, const std::array<int, Dimension>& axes)
    : doubles_(doubles), axes_(axes)
  {}

  void ask_for(std::size_t position) const { doubles_.ask_for(position); }
  double at(std::size_t position, int axis) const { return doubles_.at(position, axes_[axis]); }

  template <int>
  std::array<double, Dimension> at(std::size_t position) const
  {
    std::array<double, Dimension> x;
    for(int axis = 0; axis < Dimension; ++axis)
      x[axis] = at(position, axis);
    return x;
  }

private:
  const All_doubles& doubles_;
  std::array<int, Dimension> axes_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_POINT_DOUBLES_H
