// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that have coordinates and nothing else, in no kernel: enough for the parts of the library
// that look at single points.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_PLAIN_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_PLAIN_POINTS_H

#include "point_scene.h"

#include <CGAL/Dimension.h>

namespace test_support {

template <class Number>
struct Plain_point
{
  using Ambient_dimension = CGAL::Dynamic_dimension_tag;

  std::vector<Number> coordinates;

  int dimension() const { return static_cast<int>(coordinates.size()); }
  const Number& cartesian(int i) const { return coordinates[static_cast<std::size_t>(i)]; }
};

template <class Number>
using Plain_points = std::vector<Plain_point<Number>>;

template <class Number = double>
Plain_points<Number> plain_points(const Points& points)
{
  Plain_points<Number> result;
  for(const Coordinates& c : points) {
    result.emplace_back();
    for(const double x : c)
      result.back().coordinates.push_back(Number(x));
  }
  return result;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_PLAIN_POINTS_H
