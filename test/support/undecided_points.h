// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Points that slabs can be made of and swept, with every pair in reach left undecided and counted.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_UNDECIDED_POINTS_H
#define THICK_INTERSECTION_TEST_SUPPORT_UNDECIDED_POINTS_H

#include "point_scene.h"

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Distance_filter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_pairs.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace test_support {

namespace internal = CGAL::Thick_intersection_d::internal;

// Points as Slabs asks for them, and a test that decides nothing: lanes leave every pair to
// is_pair().
template <int Dimension>
struct Undecided_points
{
  using Point = internal::Slab_point<Dimension, double>;
  using Run = typename Point::Run;

  explicit Undecided_points(const Points& points, double reach)
    : points(points), near{reach, filter.inside, filter.outside}
  {}

  internal::Interval interval(int axis) const
  {
    internal::Interval interval;
    for(const Coordinates& c : points)
      interval.add(c[axis]);
    return interval;
  }
  double coordinate(std::size_t position, int axis) const { return points[position][axis]; }
  void put(std::size_t position, Point& place) const
  {
    std::copy_n(points[position].begin(), Dimension, place.x.begin());
    place.position = static_cast<internal::Place>(position);
  }

  const internal::Near_question<double>& question() const { return near; }
  void ask_for(internal::Place) const {}
  bool is_pair(const Run&, const Run&, internal::Found_pair, internal::Found_pair,
               internal::Decision_counts&) const
  {
    ++count;
    return false;
  }

  const Points& points;
  const internal::Distance_filter filter;
  const internal::Near_question<double> near;
  mutable std::size_t count = 0;
};

} // namespace test_support

#endif // THICK_INTERSECTION_TEST_SUPPORT_UNDECIDED_POINTS_H
