// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The recursive route, which is [V03] as written, with the choices that the paper discusses. No
// other file of the benchmarks knows how the library calls it.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_RECURSIVE_ROUTE_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_RECURSIVE_ROUTE_H

#include "support/recursion_variants.h"

#include <CGAL/Thick_point_traits_d.h>

namespace thick_benchmark {

using test_support::Base_case;
using test_support::Pivot;
using test_support::Recursion_variant;
using test_support::search_by_variant;

// The traits of points with the reach that [V03] allows for any choice of reference points: twice
// the diameter D of the balls, where the centres of equal balls need D only.
template <class Point>
class Literal_reach_traits : public CGAL::Thick_point_traits_d<Point>
{
  using Base = CGAL::Thick_point_traits_d<Point>;

public:
  explicit Literal_reach_traits(double r)
    : Base(CGAL::within_distance(r)), wide_(CGAL::within_distance(2 * r))
  {}

  typename Base::Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return wide_.is_close_along_axis_d_object();
  }

private:
  Base wide_;
};

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_RECURSIVE_ROUTE_H
