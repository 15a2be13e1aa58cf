// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NARROW_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NARROW_POINTS_H

// Points within a distance as 32-bit integers: a source and a test for the slab route, like
// Near_points, which decides what the integers cannot.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Decision_counts.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Narrow_scale.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Found_pairs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/lanes/Near_pairs.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// `Points` are Near_points.
template <int Dimension, class Points>
class Narrow_points
{
public:
  using Point = Slab_point<Dimension, std::int32_t>;
  using Run = typename Point::Run;

  // The scale is to be usable.
  Narrow_points(const Points& points, const Narrow_scale<Dimension>& scale)
    : points_(points), scale_(scale)
  {}

  static constexpr bool has_numbers = Points::has_numbers;

  std::size_t size() const { return points_.size(); }
  double reach() const { return scale_.question().reach; }

  Interval interval(int axis) const
  {
    const Interval interval = points_.interval(axis);
    return {double(scale_.narrow(interval.low, axis)), double(scale_.narrow(interval.high, axis))};
  }
  std::int32_t coordinate(std::size_t position, int axis) const
  {
    return scale_.narrow(points_.coordinate(position, axis), axis);
  }
  void put(std::size_t position, Point& place) const
  {
    typename Points::Point point;
    points_.put(position, point);
    for(std::size_t axis = 0; axis < Dimension; ++axis)
      place.x[axis] = scale_.narrow(point.x[axis], axis);
    place.position = point.position;
  }

  Place number(std::size_t position) const { return points_.number(position); }
  bool are_all_pairs() const { return points_.are_all_pairs(); }

  const Near_question<std::int32_t>& question() const { return scale_.question(); }

  void ask_for(Place position) const
  {
    if(!scale_.is_exact())
      points_.ask_for_doubles(position);
  }

  bool is_pair(const Run& a, const Run& b, Found_pair pair, Found_pair at,
               Decision_counts& counts) const
  {
    if(!scale_.is_exact())
      return points_.is_pair(at, counts);
    std::uint64_t square = 0;
    for(int axis = 0; axis < Dimension; ++axis) {
      const std::int64_t gap = std::int64_t(a.x[axis][pair.i]) - b.x[axis][pair.j];
      square += static_cast<std::uint64_t>(gap * gap);
    }
    counts.add(Arithmetic_tier::INT64);
    return scale_.holds_for(square);
  }

  void publish(const Decision_counts& counts) const { points_.publish(counts); }

private:
  const Points& points_;
  const Narrow_scale<Dimension> scale_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_NARROW_POINTS_H
