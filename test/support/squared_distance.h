// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The squared distance of two points, computed in numbers of any type. That of two points of
// integers, as doubles, is squared_distance<Integer>(p, q).

#ifndef THICK_INTERSECTION_TEST_SUPPORT_SQUARED_DISTANCE_H
#define THICK_INTERSECTION_TEST_SUPPORT_SQUARED_DISTANCE_H

#include "standard_library.h"

namespace test_support {

template <class Number, class Point>
Number squared_distance(const Point& p, const Point& q)
{
  Number sum = 0;
  for(std::size_t axis = 0; axis < p.size(); ++axis) {
    const Number gap = Number(p[axis]) - Number(q[axis]);
    sum += gap * gap;
  }
  return sum;
}

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_SQUARED_DISTANCE_H
