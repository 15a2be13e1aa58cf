// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that count how often they are looked at.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_COUNTED_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_COUNTED_POINTS_H

#include "standard_library.h"

namespace test_support {

template <class Point>
struct Counted_points
{
  using value_type = Point;
  const std::vector<Point>& points;
  std::size_t& count;

  std::size_t size() const { return points.size(); }
  const Point& operator[](std::size_t i) const
  {
    ++count;
    return points[i];
  }
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_COUNTED_POINTS_H
