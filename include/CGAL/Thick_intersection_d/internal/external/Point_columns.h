// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_POINT_COLUMNS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_POINT_COLUMNS_H

// Points in memory, with their ids.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A point as searches read it, like a point of CGAL.
template <int Dimension>
struct Stored_point
{
  using Ambient_dimension = Dimension_tag<Dimension>;

  std::array<double, Dimension> x;

  int dimension() const { return Dimension; }
  double cartesian(int axis) const { return x[static_cast<std::size_t>(axis)]; }
};

// Points and their ids, which are their positions in the user's range, in a column each.
template <int Dimension>
struct Point_columns
{
  Stored_point<Dimension>* points;
  std::uint64_t* ids;

  Point_columns from(std::size_t place) const { return {points + place, ids + place}; }

  void set(std::size_t place, const Stored_point<Dimension>& point, std::uint64_t id) const
  {
    points[place] = point;
    ids[place] = id;
  }
};

// The bytes of a point and its id.
template <int Dimension>
inline constexpr std::size_t stored_size = sizeof(Stored_point<Dimension>) + sizeof(std::uint64_t);

// Memory for columns.
template <int Dimension>
class Column_buffers
{
public:
  // Points that were there before may be lost.
  void require(std::size_t size)
  {
    points_.require(size);
    ids_.require(size);
  }

  Point_columns<Dimension> columns() const { return {points_.data(), ids_.data()}; }

private:
  Buffer<Stored_point<Dimension>> points_;
  Buffer<std::uint64_t> ids_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_POINT_COLUMNS_H
