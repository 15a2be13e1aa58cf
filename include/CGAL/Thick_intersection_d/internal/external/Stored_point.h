// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINT_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINT_H

// A point on disk, and in the memory of a search.

#include <CGAL/Dimension.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Searches read it like a point of CGAL.
template <int Dimension>
struct Stored_point
{
  using Ambient_dimension = Dimension_tag<Dimension>;

  Stored_point() {} // sets nothing: a vector of points that are to be read is touched once
  Stored_point(const std::array<double, Dimension>& coordinates, std::uint64_t position)
    : x(coordinates), id(position)
  {}

  int dimension() const { return Dimension; }
  double cartesian(int axis) const { return x[static_cast<std::size_t>(axis)]; }
  std::pair<double, double> bounds_along(int axis) const
  {
    return {cartesian(axis), cartesian(axis)};
  }

  std::array<double, Dimension> x;
  std::uint64_t id; // its position in the user's range
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINT_H
