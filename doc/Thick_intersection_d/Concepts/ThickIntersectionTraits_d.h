// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgThickIntersectionDConcepts
\cgalConcept

The concept `ThickIntersectionTraits_d` is required of the named parameter `geom_traits` of
`CGAL::thick_self_intersection_d()` and `CGAL::thick_intersection_d()`. It tells the type of the
objects, and the three predicates by which the algorithm sees them.

The concept is the computation model of \cgalCite{v-riato-03}, section 2.1. Each object has a point,
its *reference point*, which the algorithm compares along the axes and never asks for. A pair that
intersects has reference points that are *close* along every axis: their coordinates differ by at
most a number which depends on the axis alone, the *reach*. The paper takes twice the diameter
\f$ D \f$ of the largest object as the reach. A smaller one will do if the reference points are
chosen well: for balls of one radius it is \f$ D \f$ if the reference points are the centres.

The number \f$ C \f$ of the paper, which is the most objects that can be pairwise disjoint while
their reference points lie in a cube with sides of two reaches, is not part of the concept. Like
\f$ D \f$ it appears in the bound on the time, and nowhere in the program.

The functors are copied, may have a state, and are called as `const`. In parallel they are called
by several threads at once. Their results need not be of the type `bool`, but must be convertible
to it. Objects need not be copyable, and the traits object itself is not copied.

What the algorithm computes are the answers of these predicates, so that its algebraic degree is
that of the predicates, and its result is exact if they are.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Thick_point_traits_d}
\cgalHasModels{CGAL::Thick_ball_traits_d}
\cgalHasModels{CGAL::Thick_object_traits_d}
\cgalHasModelsEnd

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
  axis this is a strict weak order. Objects of which neither comes before the other are equivalent
  along that axis; they need not be equal.

  Degree 1, where coordinates of the reference points are given.
  */
  typedef unspecified_type Less_coordinate_d;

  /*!
  tells whether two objects may intersect as far as an axis shows, by

  `bool operator()(const Object_d& a, const Object_d& b, int i) const`,

  which is symmetric in `a` and `b` and obeys this law: let `a` and `b` intersect, and let `c` be an
  object between them along axis `i`, which neither comes before the first of the two nor is
  preceded by the last one; then the operator returns `true` for `a` and `b`, for `a` and `c`, and
  for `c` and `b`. The comparison of the difference of two coordinates with the reach obeys it, also
  with a difference that is rounded once to the nearest number, upwards or downwards, if the reach
  is not rounded down.

  It may return `true` too often. This costs time, but loses no pair and makes no duplicates. If it
  returns `false` where the law asks for `true`, pairs are lost.

  Degree 1 or less: it may be decided on approximations.
  */
  typedef unspecified_type Is_close_along_axis_d;

  /*!
  decides whether two objects intersect, by

  `bool operator()(const Object_d& a, const Object_d& b) const`,

  which is symmetric in `a` and `b`. It is never called for an element and itself, but is called for
  equal elements at different positions.

  This need not be the intersection of sets. Any symmetric relation that the law of
  `Is_close_along_axis_d` holds for is allowed, such as "these ships are less than a mile apart and
  of different owners"; the bound on the time then speaks of objects that are pairwise not in the
  relation.
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
