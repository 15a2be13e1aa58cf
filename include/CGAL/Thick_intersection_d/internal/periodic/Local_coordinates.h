// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_LOCAL_COORDINATES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_LOCAL_COORDINATES_H

// Where points are from a place among them. Images of points depend on differences of coordinates
// alone. A rounded difference is off by 2^-52 of itself, in every rounding mode, wherever the scene
// lies; a product of a coordinate would be off by that much of the coordinate.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Dimension>
class Local_coordinates
{
public:
  using Vector = std::array<double, Dimension>;

  // Takes the middle of the scene as the place.
  explicit Local_coordinates(const Scene& scene) : error_(scene.error)
  {
    for(int axis = 0; axis < Dimension; ++axis) {
      const Interval& interval = scene.box[axis];
      place_[axis] = interval.low / 2 + interval.high / 2; // so no difference overflows
      box_[axis] = {interval.low - place_[axis], interval.high - place_[axis]};
    }
  }

  // Takes the first point as the place, and subtracts it without error. This takes longer. It is
  // for points whose coordinates are no doubles, and so far away that doubles do not part them.
  template <class Elements>
  void subtract_exactly(const Elements& points)
  {
    is_exact_ = true;
    error_ = 0;
    for(int axis = 0; axis < Dimension; ++axis)
      exact_place_[axis] = to_exact_rational(coordinate(points[0], axis));
    box_.fill(Interval());
    for(std::size_t position = 0; position < points.size(); ++position) {
      const Vector difference = difference_without_error(points[position]);
      for(int axis = 0; axis < Dimension; ++axis)
        box_[axis].add(difference[axis]);
    }
  }

  // Returns the difference of a point and the place. It is off by 2^-51 of itself and by error().
  template <class Point>
  Vector operator()(const Point& point) const
  {
    if constexpr(!is_held_by_double_v<Coordinate_t<Point>>)
      if(is_exact_)
        return difference_without_error(point);
    Vector difference;
    for(int axis = 0; axis < Dimension; ++axis)
      difference[axis] = coordinate_bounds(point, axis).first - place_[axis];
    return difference;
  }

  bool is_exact() const { return is_exact_; }

  // The place. The double that is read of a coordinate, minus it, is rounded to the difference.
  // \pre !is_exact()
  double place(int axis) const { return place_[axis]; }

  // The differences along an axis, up to their error.
  const Interval& interval(int axis) const { return box_[axis]; }

  // How far the double that is read of a coordinate may be below the coordinate.
  double error() const { return error_; }

private:
  template <class Point>
  Vector difference_without_error(const Point& point) const
  {
    Vector difference;
    for(int axis = 0; axis < Dimension; ++axis)
      difference[axis] = bounds(Exact_rational(to_exact_rational(coordinate(point, axis))
                                               - exact_place_[axis])).first;
    return difference;
  }

  bool is_exact_ = false;
  double error_ = 0;
  Vector place_ = {};
  std::array<Exact_rational, Dimension> exact_place_;
  std::array<Interval, Dimension> box_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PERIODIC_LOCAL_COORDINATES_H
