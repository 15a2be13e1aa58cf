// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CARRIED_DOUBLES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CARRIED_DOUBLES_H

// A point whose coordinates are doubles, on its way to the part that searches it.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/parts/Byte_reader.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// One value for each axis. `Dimension` is 0 if it is known at run time only.
template <int Dimension, class Value>
using Values_along_axes
  = std::conditional_t<Dimension == 0, std::vector<Value>,
                       std::array<Value, static_cast<std::size_t>(Dimension)>>;

template <int Dimension>
using Carried_dimension
  = std::conditional_t<Dimension == 0, Dynamic_dimension_tag, Dimension_tag<Dimension>>;

template <int Dimension, class Value>
void resize_values(Values_along_axes<Dimension, Value>& values, int dimension)
{
  if constexpr(Dimension == 0)
    values.resize(static_cast<std::size_t>(dimension));
}

// Searches read it like a point of CGAL.
template <int Dimension>
class Carried_doubles
{
public:
  using Ambient_dimension = Carried_dimension<Dimension>;

  Carried_doubles() = default;

  template <class Point>
  explicit Carried_doubles(const Point& point)
  {
    resize_values<Dimension, double>(x_, point.dimension());
    for(int axis = 0; axis < dimension(); ++axis)
      x_[static_cast<std::size_t>(axis)] = coordinate_bounds(point, axis).first;
  }

  int dimension() const { return static_cast<int>(x_.size()); }
  double cartesian(int axis) const { return x_[static_cast<std::size_t>(axis)]; }
  std::pair<double, double> bounds_along(int axis) const
  {
    return {cartesian(axis), cartesian(axis)};
  }

  // The least number of bytes that a point is packed into.
  static std::size_t packed_size(int dimension)
  {
    return static_cast<std::size_t>(dimension) * sizeof(double);
  }

  void pack(std::vector<char>& bytes) const { write_bytes(x_.data(), x_.size(), bytes); }

  void unpack(Byte_reader& bytes, int dimension)
  {
    resize_values<Dimension, double>(x_, dimension);
    bytes.read(x_.data(), x_.size());
  }

private:
  Values_along_axes<Dimension, double> x_{};
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PARTS_CARRIED_DOUBLES_H
