// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEAR_POINT_BOXES_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEAR_POINT_BOXES_H

// Points within a distance as boxes, for the box route: two points are within reach along all axes
// if the boxes meet that begin at the points and are as long as the reach.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Elements>
class Near_point_boxes
{
  using Point = typename Elements::value_type;

public:
  using Box_filter = void;
  static constexpr int static_dimension = dimension_or<Point>(0);

  Near_point_boxes(const Elements& points, const Is_within_distance<Point>& is_within)
    : points_(points), is_within_(is_within)
  {}

  std::size_t size() const { return points_.size(); }
  int dimension() const { return is_within_.dimension(); }

  auto intervals(std::size_t position) const
  {
    return [this, position](int axis) {
      const std::pair<double, double> x = coordinate_bounds(points_[position], axis);
      const double end = x.second + is_within_.reach(); // rounded once
      return Interval{x.first, std::nextafter(end, std::numeric_limits<double>::infinity())};
    };
  }

  bool are_exact() const { return false; }
  void ask_for(std::size_t) const {}
  bool do_intersect(std::size_t i, std::size_t j) const
  {
    return is_within_(points_[i], points_[j]);
  }

private:
  const Elements& points_;
  const Is_within_distance<Point>& is_within_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_DOORS_NEAR_POINT_BOXES_H
