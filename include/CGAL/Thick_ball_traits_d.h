// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_BALL_TRAITS_D_H
#define CGAL_THICK_BALL_TRAITS_D_H

// Closed balls with individual radii.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/objects/ball_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Do_balls_intersect.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDTraits

is the traits class for closed balls with individual radii. Two balls intersect if the distance of
their centers is at most the sum of their radii. Balls are solid, unlike spheres: a ball within
another ball intersects it. The predicates give the answer of real arithmetic on the given centers
and radii. They have degree 1 and 2 \cgalCite{v-riato-03}. With squared radii, as in `Sphere_3`, the
degree would be 4.

A search encloses the balls in boxes, and tests the pairs whose boxes meet. So balls may have any
radii. If all balls of a search have the same radius, it searches the centers as points within twice
the radius, as `fixed_radius_near_neighbors()` does; the search reads the radii only to find this
out.

The predicates of `ThickIntersectionTraits_d` compare the centers. The reach along each axis is
twice the largest radius \cgalCite{v-riato-03}. A search uses these predicates if a box reaches
beyond the range of doubles.

Objects of this class may be used by several threads at once.

\tparam Point is `Point_2`, `Point_3` or `Point_d` of a kernel of \cgal.

\cgalModels{ThickIntersectionTraits_d}
\cgalModels{ThickIntersectionIntervalTraits_d}
*/
template <class Point>
class Thick_ball_traits_d
{
  using Number = Thick_intersection_d::internal::Coordinate_t<Point>;

public:
  /// \name Types
  /// @{

  /// the balls: a center, and a radius of the number type of its coordinates.
  using Object_d = std::pair<Point, Number>;

  /// compares the centers of two balls along an axis.
  class Less_coordinate_d
  {
  public:
    /// returns whether the center of `a` is before the center of `b` along axis `i`. Degree 1.
    bool operator()(const Object_d& a, const Object_d& b, int i) const
    {
      using Thick_intersection_d::internal::coordinate;
      return coordinate(a.first, i) < coordinate(b.first, i);
    }
  };

  /// bounds the distance of the centers of two balls along an axis.
  class Is_close_along_axis_d
  {
  public:
    /// returns whether the centers differ by at most the reach along axis `i`, up to rounding to
    /// the safe side.
    bool operator()(const Object_d& a, const Object_d& b, int i) const
    {
      using Thick_intersection_d::internal::coordinate;
      return Thick_intersection_d::internal::is_within_reach(coordinate(a.first, i),
                                                             coordinate(b.first, i), reach_);
    }

  private:
    friend class Thick_ball_traits_d;
    explicit Is_close_along_axis_d(double reach) : reach_(reach) {}
    double reach_;
  };

  /// decides whether two balls intersect.
  /// It has `bool operator()(const Object_d& a, const Object_d& b) const`, of degree 2.
  using Do_intersect_d = Thick_intersection_d::internal::Do_balls_intersect<Point>;

  /// encloses a ball along an axis.
  class Interval_d
  {
  public:
    /// returns an interval that holds the ball `a` along axis `i`: the center minus and plus the
    /// radius, rounded outwards.
    std::pair<double, double> operator()(const Object_d& a, int i) const
    {
      return Thick_intersection_d::internal::ball_interval(a, i);
    }
  };

  /// the dimension of the balls.
  using Dimension = Thick_intersection_d::internal::Point_dimension_t<Point>;

  /// @}
  /// \name Creation
  /// @{

  /// constructs the traits for the balls of the given ranges of `Object_d`, in one pass.
  template <class... BallRange>
  explicit Thick_ball_traits_d(const BallRange&... balls)
  {
    (add(balls), ...);
  }

  /// @}

#ifndef DOXYGEN_RUNNING
  // Throws if a coordinate of `ball` is NaN or infinite, or if its radius is negative, NaN or
  // infinite.
  void check(const Object_d& ball, std::size_t position) const
  {
    Thick_intersection_d::internal::check_ball(ball, dimension_, position);
  }
#endif

  /// \name Operations
  /// @{

  /// returns the dimension of the balls, or 0 if there are none.
  int dimension() const { return dimension_; }

  /// returns the comparison of centers along axes.
  Less_coordinate_d less_coordinate_d_object() const { return Less_coordinate_d(); }

  /// returns the test for close centers.
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return Is_close_along_axis_d(2 * largest_radius_);
  }

  /// returns the test for balls that intersect.
  Do_intersect_d do_intersect_d_object() const { return Do_intersect_d(dimension_); }

  /// returns the functor of intervals.
  Interval_d interval_d_object() const { return Interval_d(); }

  /// @}

private:
  template <class BallRange>
  void add(const BallRange& balls)
  {
    for(const Object_d& ball : balls) {
      dimension_ = Thick_intersection_d::internal::dimension_of(ball.first);
      largest_radius_ = (std::max)(
        largest_radius_, Thick_intersection_d::internal::bounds(ball.second).second);
    }
  }

  double largest_radius_ = 0;
  int dimension_ = 0;
};

} // namespace CGAL

#endif // CGAL_THICK_BALL_TRAITS_D_H
