// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_FEATURE_INTERSECTION_D_H
#define CGAL_THICK_FEATURE_INTERSECTION_D_H

// All pairs of polylines, polygons and triangle meshes that intersect, or are within a distance, in
// one range or between two ranges.

#include <CGAL/Distance_bound.h>
#include <CGAL/Element_callback.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/interiors.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/features/feature_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/features/piece_tests.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of features of a range that intersect, each exactly once, however many of their
segments or faces meet.

A feature is one of these, with points of one type, `Point_2` or `Point_3` of any kernel:

- A *polyline*: a range of points with forward iterators, such as `std::vector<Point_3>`. One point
  is a polyline that is this point, and so is a `Point_2` or `Point_3` itself.
- A *polygon* in the plane, closed and filled: `Polygon_2`. It has the points of its edges, and all
  points that a ray leaves through an odd number of edges. So simple polygons may have either
  orientation, rings may touch themselves, and a polygon of one or two vertices is a point or a
  segment.
- A *polygon with holes*, `Polygon_with_holes_2`. Holes are open: their edges belong to the polygon.
  Holes lie in the outer boundary, and not in other holes. They may touch these.
- A *triangle mesh* in space: a model of `FaceListGraph`, `HalfedgeListGraph` and
  `VertexListGraph` with points, such as `Surface_mesh` or `Polyhedron_3`, or a class that derives
  from one of these. It has the points of its faces. If it is closed, it is a *solid*, and has
  besides all points from which a ray crosses its faces an odd number of times. So the orientation
  of faces does not matter, shells in shells are hollows, and a mesh that intersects itself is as
  well defined as others. A mesh is closed if each edge, as the pair of the points at its ends,
  belongs to an even number of its faces, so it need not be a manifold, and faces that are not
  stitched together are connected by equal points. Faces may be degenerate: an edge of length zero
  does not count. No face has one edge or two, as `CGAL::is_valid_polygon_mesh()` requires: such a
  face may not be seen in a mesh whose box meets that of no other feature.
- A *triangle soup*: a `std::pair` of a range of `Point_3` and of a range of triples of indices of
  these points, such as `std::vector<std::array<std::size_t, 3>>`. It is taken as a mesh, and may
  repeat points.
- A *thickened* feature: a `std::pair` of a feature and a radius. It is all points within the radius
  of the feature, as roads and cables are. Radii are numbers of one type, not negative, and of an
  integer type only if the coordinates are, because an integer may be an index. A feature of which a
  member has a radius has no radius itself.
- A `std::variant` of features.
- A range of features. It is the union of them, as the multipolygons and collections of geographic
  files are.

A feature without points is in no pair. Two features intersect iff they have a point in common:
their segments or faces meet, or one lies inside a polygon or solid of the other. A feature is never
paired with itself. The search gives the result of real arithmetic on the coordinates that the
points hold, as `thick_self_intersection_d()` does, for every kernel.

In a range `interiors(features)`, all features are polygons or unions of them, and have their
interiors alone. Neither they nor the features of another range have a radius then. The interior of
a polygon has the points off its edges that a ray leaves through an odd number of edges. The
interior of a union is the union of the interiors of its members: what they share of their
boundaries is in none. So the pairs of such a range are those that overlap. Polygons that share
borders are none, and equal ones are. Polygons without area have no interior, and are in no pair.

The search takes the segments of all features through the divide and conquer of
`thick_self_intersection_d()`. It tests those whose boxes meet, as long as their features are not
known to be a pair. What is left are features whose boundaries do not meet. One of these is inside a
polygon if its first vertex is, which is asked if this vertex is in the box of the polygon. Segments
of one feature are not compared, whatever its shape: a track that stays at a place and nested rings
of a multipolygon take no more time than others.

If there are meshes, the features are searched by their boxes. The segments and faces of a feature
get a tree of boxes, if they are where its box meets that of another feature. Two features whose
boxes meet are compared at once, by their trees, until a pair of their segments or faces meets, and
by the divide and conquer above if this takes more steps than they have segments and faces. If none
meets, one vertex of each connected component of one feature that is in the box of the other is
asked whether it is inside a solid of that. A solid of which this is asked gets a tree of all of its
faces, and the ray upwards from the vertex is followed.

Let there be \f$ n \f$ segments and \f$ k \f$ reported pairs. Let \f$ K \f$ be the number of pairs
of segments of different features whose boxes meet, before the features are known to be a pair. Let
\f$ K_f \f$ be the number of pairs of a segment and a feature that form a reported pair of features,
if the box of the segment meets one of the feature: at most \f$ n \f$ for two features, and at most
the number of boxes that meet. Let \f$ K_v \f$ be the number of first vertices in the boxes of
polygons that their features do not meet. Then the search takes \f$ O((n + K_f) \log n + K) \f$ time
in the plane and \f$ O((n + K_f) \log^2 n + K) \f$ in space, and for each of the \f$ K_v \f$
vertices \f$ O(\log^2 n) \f$ time for most shapes. It is \f$ O(c \log n) \f$ at most, where
\f$ c \f$ is the number of edges at the height of the vertex: a spiral takes that much. The search
takes \f$ O(n + k) \f$ space.

If there are meshes, let \f$ n \f$ be the number of features, and \f$ m \f$ that of their points,
segments and faces. Let \f$ K \f$ be the number of pairs of features whose boxes meet, \f$ P \f$ the
sum of the numbers of segments and faces of their two trees over these pairs, and \f$ K_t \f$ the
number of pairs of a segment or face of each whose boxes meet, until two features are known to be a
pair. Then the search takes \f$ O(n \log^2 n + m \log m + K + P \log^2 m + K_t) \f$ time at most,
and for each vertex that is asked \f$ O(\sqrt{m} + c) \f$ time for most shapes, where \f$ c \f$ is
the number of boxes of faces that are above the vertex. It takes \f$ O(m) \f$ space.

Interiors are asked about where boundaries meet, as long as features are not known to be a pair.
Let \f$ K_c \f$ be the number of pairs of edges that meet where none of them ends. Each of them
takes as much time as a vertex in a polygon, and a point takes \f$ O(m \log m) \f$ a few times for
two polygons, where \f$ m \f$ is the number of their edges there. If edges of a polygon cancel in
another one, as those of an antenna do, all vertices of both are asked about, once for two polygons,
which are remembered: the search takes \f$ O(n + k + k_a) \f$ space for \f$ k_a \f$ times two such
polygons. If edges of both cross at one point where other edges of the polygons may be too, exact
numbers decide.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel, the same pairs are reported
in any order. Several threads call the callback at once, so it must allow this. If there are meshes,
they also read the features and the property map at the same time, before the first report and after
it, so these must allow this as well. `Parallel_tag` requires \tbb.

\tparam FeatureRange is a range of features with forward iterators or better. It is not reordered.
It may be a view of C++20. It may be the result of `interiors()`.

\tparam Callback is as for `thick_self_intersection_d()`.

\param features the features.
\param callback is called for each pair, with the positions \f$ i < j \f$ of the two features in the
range, or with the elements at these positions.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating features to the elements of the range}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to features}
    \cgalParamDefault{the elements are the features}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor that is called with the progress between 0 and 1, and cancels
                          the search by returning `false`}
    \cgalParamType{a functor with `bool operator()(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{In parallel, one thread at a time calls it, but not always the same thread.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument if a coordinate is NaN or infinite, if a radius is negative, NaN or
infinite, if a polygon with holes has no outer boundary, if a face is no triangle, or if an index is
beyond the points, before anything is reported. The message gives the position of the feature, and
of the face in its mesh. Exceptions of the callback pass through.
\throws std::length_error if there are 2<sup>31</sup> - 1 features, or segments and faces, or parts
of features and polygons together, or vertices of the faces of a mesh, or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `thick_feature_intersection_d()`
\sa `thick_self_intersection_d()`
\sa `interiors()`
\sa `with_elements()`
*/
template <class ConcurrencyTag = Sequential_tag, class FeatureRange, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool thick_feature_self_intersection_d(FeatureRange&& features, Callback&& callback,
                                       const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::search_features(internal::Pieces_intersect(), callback, np,
                                   internal::Threads(ConcurrencyTag()), features);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a feature of one range and a feature of another that intersect, each exactly
once.

Pairs within a range are neither reported nor tested. Otherwise the function is as
`thick_feature_self_intersection_d()`, where \f$ n \f$ is the number of segments of both ranges.

One range may be the result of `interiors()`, or both. If one is, the features of the other one are
closed: a pair is the interior of a polygon and a feature that has a point in it. So the roads that
only run along the border of a parcel are in no pair with it.

\param features_a, features_b the features. The ranges may have features of different kinds, with
points of the same type.
\param callback is called for each pair with the position \f$ i \f$ of its feature in `features_a`
and the position \f$ j \f$ of its feature in `features_b`, or with the elements at these positions.
\param np as for `thick_feature_self_intersection_d()`; the property map is applied to both ranges.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as `thick_feature_self_intersection_d()`. Positions in the message go
on from the first range to the second range.

\sa `thick_feature_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class FeatureRangeA, class FeatureRangeB,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool thick_feature_intersection_d(FeatureRangeA&& features_a, FeatureRangeB&& features_b,
                                  Callback&& callback,
                                  const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::search_features(internal::Pieces_intersect(), callback, np,
                                   internal::Threads(ConcurrencyTag()), features_a, features_b);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of features of a range whose distance is within a bound, each exactly once.

Features are as for `thick_feature_self_intersection_d()`. Their distance is that of their closest
points, and zero if they intersect, as a polygon or solid and a feature inside it do. Interiors are
not needed: they are within a distance iff the features are closer, which `bound.open()` says. The
search gives the result of real arithmetic on the given coordinates and the given bound, for pairs
exactly at the bound too, as `fixed_radius_near_neighbors()` of segments does.

The time and the space are those of `thick_feature_self_intersection_d()`, where boxes count as
meeting if they are within the bound along each axis.

\param features,callback,np as for `thick_feature_self_intersection_d()`.
\param bound made by `within_distance()` or `within_squared_distance()`.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as `thick_feature_self_intersection_d()`, and if the bound is negative
or NaN.

\sa `thick_feature_self_intersection_d()`
\sa `fixed_radius_near_neighbors()`
*/
template <class ConcurrencyTag = Sequential_tag, class FeatureRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_features(FeatureRange&& features, const Distance_bound<NT>& bound,
                                Callback&& callback,
                                const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::search_features(bound, callback, np, internal::Threads(ConcurrencyTag()),
                                   features);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a feature of one range and a feature of another whose distance is within a
bound, each exactly once.

Pairs within a range are neither reported nor tested. Otherwise the function is as the version
above.

\param features_a,features_b,callback,np as for `thick_feature_intersection_d()`.
\param bound made by `within_distance()` or `within_squared_distance()`.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as `thick_feature_intersection_d()`, and if the bound is negative or
NaN.

\sa `thick_feature_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class FeatureRangeA, class FeatureRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_features(FeatureRangeA&& features_a, FeatureRangeB&& features_b,
                                const Distance_bound<NT>& bound, Callback&& callback,
                                const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::search_features(bound, callback, np, internal::Threads(ConcurrencyTag()),
                                   features_a, features_b);
}

} // namespace CGAL

#endif // CGAL_THICK_FEATURE_INTERSECTION_D_H
