// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgThickIntersectionDConcepts
\cgalConcept

The named parameter `geom_traits` of `CGAL::thick_self_intersection_d()` and
`CGAL::thick_intersection_d()` may be a model of the concept `ThickIntersectionIntervalTraits_d`.
The concept requires the type of the objects, the interval of an object along each axis, and the
intersection test. The intervals of an object are its *box*.

The traits must obey one law: if two objects intersect, their intervals meet along every axis.
Intervals are closed, and meet if they have a number in common. An interval may be larger than the
object. This costs time, but loses no pair and makes no duplicates. If the law is broken, pairs are
lost.

Objects may have any sizes. The time depends on how many boxes meet, and not on the ratio of the
largest object to the smallest.

The functors are copied, may have a state, and are called as `const`. In parallel, several threads
call them at once. They give the same answer whenever they are asked about the same objects. Objects
need not be copyable, and the traits object itself is not copied.

The algorithm compares the ends of intervals, and asks the intersection test about pairs whose boxes
meet. So its result is exact if the intersection test is exact and the law holds. If the ends are
computed, round them outward.

A class may be a model of `ThickIntersectionTraits_d` as well, like the classes of the package. Then
the intervals are used, and the predicates of that concept only if an interval is infinite.

<b>Two types.</b> The two ranges of `CGAL::thick_intersection_d()` may hold objects of two types.
Then a model need not have the type `Object_d`. `Interval_d` takes objects of either type, and
`Do_intersect_d` takes an object of the first range and one of the second, in this order.

A model may have a member function `check(object, position)`. It is called for each object and its
position before anything else, and may throw. The positions in a second range go on from the first
range. Of two types, those are checked that the function takes.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Thick_ball_traits_d}
\cgalHasModels{CGAL::Thick_object_traits_d}
\cgalHasModelsEnd

\sa `ThickIntersectionTraits_d`
\sa `CGAL::thick_self_intersection_d()`
\sa `CGAL::thick_intersection_d()`
*/
class ThickIntersectionIntervalTraits_d
{
public:
  /// \name Types
  /// @{

  /// the type of the objects.
  typedef unspecified_type Object_d;

  /*!
  gives the interval of an object along an axis, by

  `std::pair<double, double> operator()(const Object_d& a, int i) const`,

  which returns the lower and the upper end for axis `i`, with `0 <= i < dimension()`. The lower end
  is not above the upper end, and neither is NaN. An end may be infinite.

  The degree is 1 or less, because approximations suffice.
  */
  typedef unspecified_type Interval_d;

  /*!
  decides whether two objects intersect, by

  `bool operator()(const Object_d& a, const Object_d& b) const`,

  which is symmetric in `a` and `b`. Its result must be convertible to `bool`, and need not be of
  this type. It is never called for an element and itself. It is called for equal elements at
  different positions.

  The relation need not be the intersection of sets. Any symmetric relation is allowed if the
  intervals obey the law, such as "these aircraft are in conflict and have different operators".
  */
  typedef unspecified_type Do_intersect_d;

  /// the number of axes, as `CGAL::Dimension_tag<d>`. This type is optional. If it is there, the
  /// search is compiled for this dimension only.
  typedef unspecified_type Dimension;

  /// @}
  /// \name Operations
  /// @{

  /// returns the number of axes. The search compares objects along up to eight of them, or up to
  /// four without the type `Dimension`: those along which the fewest objects of a sample meet. It
  /// looks at the others only where very many boxes meet.
  int dimension() const;

  /// returns the functor of intervals.
  Interval_d interval_d_object() const;

  /// returns the test for intersection.
  Do_intersect_d do_intersect_d_object() const;

  /// @}
};
