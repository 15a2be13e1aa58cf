// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgThickIntersectionDConcepts
\cgalConcept

The named parameter `geom_traits` of `CGAL::fixed_radius_near_neighbors()` and
`CGAL::fixed_radius_neighbor_lists()` is a model of the concept `ThickDistanceTraits_d` if the
ranges hold objects that the package does not know, or if their distance is another one than that of
Euclid: that of Manhattan, for points. The concept requires the interval of an object along each
axis, and the test whether two objects are within a bound.

The traits must obey one law: if two objects are within a distance \f$ r \f$, their intervals are
within \f$ r \f$ along every axis. Intervals that enclose the objects obey it. They may be larger
than the objects. This costs time, but loses no pair and makes no duplicates. If the law is broken,
pairs are lost.

The functors are called as `const`. In parallel, several threads call them at once. They give the
same answer whenever they are asked about the same objects.

If the two ranges hold objects of two types, `Interval_d` takes objects of either type, and
`Is_within_distance_d` takes an object of the first range and one of the second, in this order.

The package does not check the ends of intervals. Traits that may meet a NaN check their objects
in a member function `check(object, position)`, as those of `ThickIntersectionIntervalTraits_d` do.

The objects are searched by their boxes, as those of `ThickIntersectionIntervalTraits_d`. The
package has no class that is a model: it knows how far its own kinds of objects are apart.

\sa `ThickIntersectionIntervalTraits_d`
\sa `CGAL::fixed_radius_near_neighbors()`
*/
class ThickDistanceTraits_d
{
public:
  /// \name Types
  /// @{

  /*!
  gives the interval of an object along an axis, by

  `std::pair<double, double> operator()(const Object& a, int i) const`,

  which returns the lower and the upper end for axis `i`, with `0 <= i < dimension()`. The ends are
  finite, and the lower one is not above the upper one.
  */
  typedef unspecified_type Interval_d;

  /*!
  decides whether two objects are within a bound, by

  `bool operator()(const Object& a, const Object& b, const CGAL::Distance_bound<NT>& bound) const`,

  which is symmetric in `a` and `b`, and gets the bound that the user of the function has given. It
  is never called for an element and itself.
  */
  typedef unspecified_type Is_within_distance_d;

  /// the number of axes, as `CGAL::Dimension_tag<d>`. This type is optional. If it is there, the
  /// search is compiled for this dimension only.
  typedef unspecified_type Dimension;

  /// @}
  /// \name Operations
  /// @{

  /// returns the number of axes.
  int dimension() const;

  /// returns the functor of intervals.
  Interval_d interval_d_object() const;

  /// returns the test for objects within a bound.
  Is_within_distance_d is_within_distance_d_object() const;

  /// @}
};
