// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgThickIntersectionDConcepts
\cgalConcept

The named parameter `geom_traits` of `CGAL::thick_self_intersection_d()` and
`CGAL::thick_intersection_d()` may be a model of the concept `ThickIntersectionTraits_d`. The
concept requires the type of the objects, and the three predicates by which the algorithm sees the
objects. It is for objects that have no intervals of doubles. Objects that have them are searched
faster, and may have any sizes: see `ThickIntersectionIntervalTraits_d`.

The concept is the computation model of \cgalCite{v-riato-03}, section 2.1. Each object has
a *reference point*. The algorithm compares reference points along the axes, and never asks for
them. If two objects intersect, their reference points are *close* along every axis: their
coordinates differ by at most the *reach*, a number that depends on the axis alone. The paper takes
twice the diameter \f$ D \f$ of the largest object as the reach. A smaller reach is enough if the
reference points are chosen well: for balls of one radius the reach is \f$ D \f$ if the reference
points are the centers.

The paper has a number \f$ C \f$: the largest number of pairwise disjoint objects whose reference
points lie in a cube with sides of two reaches. This number is not part of the concept. Like
\f$ D \f$ it appears in the bound on the time, and nowhere in the program.

The functors are copied, may have a state, and are called as `const`. In parallel, several threads
call them at once. Their results must be convertible to `bool`, and need not be of this type.
Objects need not be copyable, and the traits object itself is not copied.

The algorithm computes nothing but the answers of these predicates. So its algebraic degree is the
degree of the predicates, and its result is exact if they are exact.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Thick_point_traits_d}
\cgalHasModels{CGAL::Thick_ball_traits_d}
\cgalHasModels{CGAL::Thick_object_traits_d}
\cgalHasModelsEnd

\sa `ThickIntersectionIntervalTraits_d`
\sa `CGAL::thick_self_intersection_d()`
\sa `CGAL::thick_intersection_d()`
*/
class ThickIntersectionTraits_d
{
public:
  /// \name Types
  /// @{

  /// the type of the objects.
  typedef unspecified_type Object_d;

  /*!
  compares the reference points of two objects along an axis, by

  `bool operator()(const Object_d& a, const Object_d& b, int i) const`,

  which returns whether `a` comes before `b` along axis `i`, with `0 <= i < dimension()`. For each
  axis this is a strict weak order. Two objects are equivalent along an axis if neither comes before
  the other. Equivalent objects need not be equal.

  The degree is 1 if the coordinates of the reference points are given.
  */
  typedef unspecified_type Less_coordinate_d;

  /*!
  decides whether two objects may intersect as far as an axis shows, by

  `bool operator()(const Object_d& a, const Object_d& b, int i) const`,

  which is symmetric in `a` and `b` and obeys the following law. Let `a` and `b` intersect, and let
  `c` be an object between them along axis `i`: `c` does not come before the first of the two, and
  the last of the two does not come before `c`. Then the operator returns `true` for `a` and `b`,
  for `a` and `c`, and for `c` and `b`.

  The comparison of the difference of two coordinates with the reach obeys the law. The difference
  may be rounded once, to the nearest number, upwards or downwards, if the reach is not rounded
  down.

  The operator may return `true` too often. This costs time, but loses no pair and makes no
  duplicates. If the operator returns `false` where the law requires `true`, pairs are lost.

  The degree is 1 or less, because approximations suffice.
  */
  typedef unspecified_type Is_close_along_axis_d;

  /*!
  decides whether two objects intersect, by

  `bool operator()(const Object_d& a, const Object_d& b) const`,

  which is symmetric in `a` and `b`. It is never called for an element and itself. It is called for
  equal elements at different positions.

  The relation need not be the intersection of sets. Any symmetric relation is allowed if the law of
  `Is_close_along_axis_d` holds for it, such as "these ships are less than a mile apart and have
  different owners". In the bound on the time, objects that are not in the relation then take the
  place of disjoint objects.
  */
  typedef unspecified_type Do_intersect_d;

  /// @}
  /// \name Operations
  /// @{

  /// returns the number of axes. Objects of dimension 0 are compared pair by pair.
  int dimension() const;

  /// returns the comparison along axes.
  Less_coordinate_d less_coordinate_d_object() const;

  /// returns the test for closeness.
  Is_close_along_axis_d is_close_along_axis_d_object() const;

  /// returns the test for intersection.
  Do_intersect_d do_intersect_d_object() const;

  /// @}
};
