// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_PERIODIC_FIXED_RADIUS_NEAR_NEIGHBORS_H
#define CGAL_PERIODIC_FIXED_RADIUS_NEAR_NEIGHBORS_H

// All pairs of points within a distance in a domain that repeats.

#include <CGAL/Distance_bound.h>
#include <CGAL/Element_callback.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Periodic_lattice_d.h>
#include <CGAL/Periodic_neighbor_lists.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_search.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of images of points whose distance is within a bound, in a domain that repeats,
each exactly once.

An offset \f$ o \f$ moves a point \f$ p \f$ to its image \f$ p + o_1 v_1 + \dots + o_d v_d \f$,
where the \f$ v_k \f$ are the periods of the domain. The pair \f$ (i, j, o) \f$ is reported if the
point \f$ i \f$ and the image of the point \f$ j \f$ are within the bound. As \f$ (j, i, -o) \f$ is
the same pair of images, moved, only one of them is reported: \f$ i < j \f$, or \f$ i = j \f$ and
the first component of \f$ o \f$ that is not zero is positive. A point is near images of itself if a
period is within the bound. The bound may be longer than the periods; then a pair of points is
reported for each image that is near.

The result is that of real arithmetic on the given coordinates, periods and bound. A moved
coordinate is never rounded: doubles that enclose it serve as a filter, and where they do not
decide, exact numbers do. So pairs exactly at the bound are right across boundaries, too, whether a
double holds the moved coordinates or not.

With \f$ m \f$ images of points beyond the boundary of the domain and within the bound of it, the
search takes \f$ O((n + m) \log (n + m) + k) \f$ time and \f$ O(n) \f$ space, where \f$ k \f$ is
the number of pairs of images within the bound \cgalCite{v-riato-03}. If periods are long beside
the bound, \f$ m \f$ is small beside \f$ n \f$. It does not depend on where the domain lies.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel, several threads call the
callback at once, which must allow this, and the pairs come in any order. `Parallel_tag` requires
\tbb.

\tparam PointRange is a range of `Point_2` or `Point_3` of a kernel of \cgal, or of `Point_d` whose
type tells that the dimension is 2 or 3, with forward iterators or better.

\tparam Domain is `Iso_rectangle_2`, `Iso_cuboid_3` or `Periodic_lattice_d`.

\tparam NT is a number type as described for `Distance_bound`.

\tparam Callback is callable with `(std::size_t i, std::size_t j, std::array<int, d> offset)`. It
returns `void`, or `bool` to stop the search by returning `false`. Or it is an output iterator for
`std::tuple<std::size_t, std::size_t, std::array<int, d> >`; one thread at a time writes to it. Or
`with_elements()` has made it, from a functor of two elements of the range and an offset.

\param points the points. An iso-box is half open: it holds the points from its minimum on, and not
its maximum, as in the periodic packages of \cgal. A lattice takes points anywhere, the lattice of
an iso-box as well; offsets are those between the points as they are given.
\param domain tells the periods. Those of an iso-box are its sides.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param callback is called for each pair.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`,
`geom_traits` and `callback`, as for `fixed_radius_near_neighbors()`.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument if a coordinate or a period is NaN or infinite, if a point is not in
the iso-box, if periods that repeat are linearly dependent, or if the bound is negative, NaN or
infinite, before anything is reported. The message gives the position of the point.
\throws std::length_error if there are 2<sup>31</sup> - 1 points and images or more, if two points
are 2<sup>29</sup> periods apart or more, or a point and an image of it, if the bound is
2<sup>28</sup> periods long or more, or if the lengths of periods differ so much that quotients of
coordinates overflow. The images are counted before they are made, and the message has their number.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `Periodic_lattice_d`
\sa `periodic_closest_pair()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Domain, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool periodic_fixed_radius_near_neighbors(
  PointRange&& points, const Domain& domain, const Distance_bound<NT>& bound, Callback&& callback,
  const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::report_periodic_pairs(domain, bound, callback, nullptr, np,
                                         internal::Threads(ConcurrencyTag()), points);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of images of points whose distance is within a bound, as the version above, and
describes the scene and the search in `profile`: the points and the images near them, the grid that
holds all of their coordinates, and how many pairs each kind of arithmetic has decided. There is no
grid if a moved coordinate is no double.

\param points,domain,bound,callback,np as in the version above.
\param profile as for `fixed_radius_near_neighbors()`; a forced tier is used for both the points and
the images.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Domain, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool periodic_fixed_radius_near_neighbors(
  PointRange&& points, const Domain& domain, const Distance_bound<NT>& bound, Callback&& callback,
  Scene_profile& profile, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::report_periodic_pairs(domain, bound, callback, &profile, np,
                                         internal::Threads(ConcurrencyTag()), points);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one range and an image of a point of another whose distance is
within a bound, in a domain that repeats, each exactly once.

Pairs within a range are neither reported nor tested. The position \f$ i \f$ is in the first range,
\f$ j \f$ in the second, and the offset \f$ o \f$ may be any. The images are those of the range for
which they are fewer; there are none if a range is empty. Otherwise the function is as the version
for one range.

\param points_a, points_b the points.
\param domain,bound,callback,np as in the version for one range.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class Domain,
          class NT, class Callback, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!Thick_intersection_d::internal::is_bound_v<Domain>>>
bool periodic_fixed_radius_near_neighbors(
  PointRangeA&& points_a, PointRangeB&& points_b, const Domain& domain,
  const Distance_bound<NT>& bound, Callback&& callback,
  const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::report_periodic_pairs(domain, bound, callback, nullptr, np,
                                         internal::Threads(ConcurrencyTag()), points_a, points_b);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of a range all images of points whose distance is within a bound, in a domain
that repeats, with the offsets of the images.

The search takes \f$ O((n + m) \log (n + m) + k \log k) \f$ time and \f$ O(n + k) \f$ space. The
result does not depend on the number of threads.

\param points,domain,bound,np as for `periodic_fixed_radius_near_neighbors()`.

\return the lists, as `Periodic_neighbor_lists` of the dimension of the points. If the progress
functor cancels the search, they hold some of the pairs, each in both of its lists.

\throws std::invalid_argument, std::length_error, std::runtime_error as
`periodic_fixed_radius_near_neighbors()`.

\sa `Periodic_neighbor_lists`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Domain, class NT,
          class NamedParameters = parameters::Default_named_parameters>
auto periodic_fixed_radius_neighbor_lists(PointRange&& points, const Domain& domain,
                                          const Distance_bound<NT>& bound,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::collect_periodic_neighbors(domain, bound, np,
                                              internal::Threads(ConcurrencyTag()), points);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of a range all images of points of another range whose distance is within a
bound, with the offsets of the images, as the version for one range.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class Domain,
          class NT, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!Thick_intersection_d::internal::is_bound_v<Domain>>>
auto periodic_fixed_radius_neighbor_lists(PointRangeA&& points_a, PointRangeB&& points_b,
                                          const Domain& domain, const Distance_bound<NT>& bound,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::collect_periodic_neighbors(domain, bound, np,
                                              internal::Threads(ConcurrencyTag()), points_a,
                                              points_b);
}

} // namespace CGAL

#endif // CGAL_PERIODIC_FIXED_RADIUS_NEAR_NEIGHBORS_H
