// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_POINT_TRAITS_D_H
#define CGAL_THICK_POINT_TRAITS_D_H

// Points that intersect if they are within a distance. They stand for balls with half the distance
// as radius, and with the center as reference point. [V03, section 1]

#include <CGAL/Dimension.h>
#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDTraits

is the traits class for points. Two points *intersect* if their distance is within a bound. All
predicates give the answer of real arithmetic on the given coordinates and the given bound, for
every kernel, `Simple_cartesian<double>` included. They have degree 1 and 2.

The reach along each axis is the bound \f$ r \f$ itself: the diameter \f$ D \f$ of the balls of
radius \f$ r/2 \f$. \cgalCite{v-riato-03} allows \f$ 2D \f$, for any choice of reference points.

Objects of this class may be used by several threads at once.

\tparam Point is `Point_2`, `Point_3` or `Point_d` of a kernel of \cgal. Its coordinates are of a
built-in floating-point type, of an exact number type, or of a binary floating-point type of any
precision.

\cgalModels{ThickIntersectionTraits_d}
*/
template <class Point>
class Thick_point_traits_d
{
  using Number = Thick_intersection_d::internal::Coordinate_t<Point>;
  using Exact = Thick_intersection_d::internal::Exact_number_t<Number>;
  using Bound = Thick_intersection_d::internal::Squared_bound<Exact>;

public:
  /// \name Types
  /// @{

  /// the points.
  using Object_d = Point;

  /// compares two points along an axis.
  class Less_coordinate_d
  {
  public:
    /// returns whether \f$ p_i < q_i \f$. Degree 1.
    bool operator()(const Point& p, const Point& q, int i) const
    {
      using Thick_intersection_d::internal::coordinate;
      return coordinate(p, i) < coordinate(q, i);
    }
  };

  /// bounds the distance of two points along an axis.
  class Is_close_along_axis_d
  {
  public:
    /// returns whether \f$ |p_i - q_i| \f$ is at most the reach, up to rounding to the safe side.
    bool operator()(const Point& p, const Point& q, int i) const
    {
      using Thick_intersection_d::internal::coordinate;
      return Thick_intersection_d::internal::is_within_reach(coordinate(p, i), coordinate(q, i),
                                                             reach_);
    }

  private:
    friend class Thick_point_traits_d;
    explicit Is_close_along_axis_d(double reach) : reach_(reach) {}
    double reach_;
  };

  /// decides whether the distance of two points is within the bound.
  /// It has `bool operator()(const Point& p, const Point& q) const`, of degree 2.
  using Do_intersect_d = Thick_intersection_d::internal::Is_within_distance<Point>;

  /// @}
  /// \name Creation
  /// @{

  /// constructs the traits for points in the plane or in space.
  /// \throws std::invalid_argument if `bound` is negative or NaN.
  template <class NT>
  explicit Thick_point_traits_d(const Distance_bound<NT>& bound)
    : Thick_point_traits_d(bound, static_dimension())
  {}

  /// constructs the traits for points of dimension `dimension`.
  /// \throws std::invalid_argument if `bound` is negative or NaN.
  template <class NT>
  Thick_point_traits_d(const Distance_bound<NT>& bound, int dimension)
    : is_within_(Bound(bound), dimension)
  {}

  /// @}

#ifndef DOXYGEN_RUNNING
  // Constructs the traits of a search that has made its test already.
  explicit Thick_point_traits_d(const Do_intersect_d& is_within) : is_within_(is_within) {}

  // Throws unless `p` is a point of this dimension with finite coordinates.
  void check(const Point& p, std::size_t position) const
  {
    Thick_intersection_d::internal::check_point(p, dimension(), "object", position);
  }
#endif

  /// \name Operations
  /// @{

  /// returns the dimension of the points.
  int dimension() const { return is_within_.dimension(); }

  /// returns the comparison of points along axes.
  Less_coordinate_d less_coordinate_d_object() const { return Less_coordinate_d(); }

  /// returns the test for points that are close along an axis.
  Is_close_along_axis_d is_close_along_axis_d_object() const
  {
    return Is_close_along_axis_d(is_within_.reach());
  }

  /// returns the test for points within the bound.
  Do_intersect_d do_intersect_d_object() const { return is_within_; }

  /// @}

private:
  static constexpr int static_dimension()
  {
    using Dimension = Thick_intersection_d::internal::Point_dimension_t<Point>;
    static_assert(!std::is_same_v<Dimension, Dynamic_dimension_tag>,
                  "The type of the points has no dimension: give it to the constructor.");
    return Dimension::value;
  }

  Do_intersect_d is_within_;
};

} // namespace CGAL

#endif // CGAL_THICK_POINT_TRAITS_D_H
