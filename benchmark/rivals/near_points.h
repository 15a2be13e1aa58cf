// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the methods that have no exact predicate of their own use: that of the package, the fastest
// one there is.

#ifndef THICK_INTERSECTION_BENCHMARK_RIVALS_NEAR_POINTS_H
#define THICK_INTERSECTION_BENCHMARK_RIVALS_NEAR_POINTS_H

#include <CGAL/Thick_point_traits_d.h>

namespace thick_benchmark {

template <class Point>
constexpr int dimension_of = CGAL::Ambient_dimension<Point>::value;

template <class Point>
using Is_near = typename CGAL::Thick_point_traits_d<Point>::Do_intersect_d;

// Returns whether two points are within r, as a function object.
template <class Point>
Is_near<Point> make_is_near(double r)
{
  return CGAL::Thick_point_traits_d<Point>(CGAL::within_distance(r)).do_intersect_d_object();
}

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_RIVALS_NEAR_POINTS_H
