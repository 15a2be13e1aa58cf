// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SPACE_BOX_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SPACE_BOX_H

// Boxes of features in space, and of pieces of them.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/bounding_box.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>

#include <boost/config.hpp> // BOOST_FORCEINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The intervals along the axes. A box of nothing is empty.
struct Space_box : std::array<Interval, 3>
{
  // Returns whether the coordinates are neither NaN nor infinite.
  template <class Point>
  BOOST_FORCEINLINE bool add_point(const Point& point)
  {
    const bool are_finite[] = {add_coordinate(point, 0), add_coordinate(point, 1),
                               add_coordinate(point, 2)}; // a loop would take longer
    return are_finite[0] && are_finite[1] && are_finite[2];
  }

  void add_box(const Space_box& other)
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
      (*this)[axis].add(other[axis]);
  }

  bool is_empty() const { return front().low > front().high; }

private:
  template <class Point>
  BOOST_FORCEINLINE bool add_coordinate(const Point& point, int axis)
  {
    const auto x = coordinate_bounds(point, axis);
    (*this)[static_cast<std::size_t>(axis)].add({x.first, x.second});
    return are_bounds_of_finite(x);
  }
};

inline bool do_boxes_meet(const Space_box& a, const Space_box& b)
{
  return do_meet(a[0], b[0]) && do_meet(a[1], b[1]) && do_meet(a[2], b[2]);
}

// Half the sum of the lengths of the edges from a corner.
inline double extent(const Space_box& box)
{
  return box[0].half_length() + box[1].half_length() + box[2].half_length();
}

inline Space_box common_part(const Space_box& a, const Space_box& b)
{
  Space_box common;
  for(std::size_t axis = 0; axis < 3; ++axis)
    common[axis]
      = {(std::max)(a[axis].low, b[axis].low), (std::min)(a[axis].high, b[axis].high)};
  return common;
}

// The interval of what is thickened by a radius, as a search with a test compares it.
template <class Test>
BOOST_FORCEINLINE
Interval searched_interval(const Interval& interval, double radius, const Test& test)
{
  std::pair<double, double> ends(interval.low, interval.high);
  if(radius != 0)
    ends = thickened_interval(ends, radius);
  ends = finite_interval(ends);
  return test.grown({ends.first, ends.second});
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_FEATURES_SPACE_BOX_H
