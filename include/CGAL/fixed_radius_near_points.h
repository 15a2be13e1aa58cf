// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FIXED_RADIUS_NEAR_POINTS_H
#define CGAL_FIXED_RADIUS_NEAR_POINTS_H

// All pairs of points within a distance, in one range or between two ranges. Programs that search
// objects, or want lists of neighbors, include <CGAL/fixed_radius_near_neighbors.h>.

#include <CGAL/Distance_bound.h>
#include <CGAL/Element_callback.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of a range whose distance is within a bound, each exactly once.

The search gives the result of real arithmetic on the given coordinates and the given bound, for
every kernel, `Simple_cartesian<double>` included, and for pairs exactly at the bound. The
`Scene_profile` chooses the arithmetic. Equal points at different positions are a pair. A point is
never paired with itself. A bound of zero finds the duplicates.

If a program includes `CGAL/fixed_radius_near_neighbors.h`, which includes this header, the range
may hold closed objects instead of points: `Segment_2`, `Triangle_2`, `Iso_rectangle_2`,
`Segment_3`, `Triangle_3`, `Iso_cuboid_3`, `Tetrahedron_3`, `Bbox_2`, `Bbox_3`, `std::pair`s of one
of these or of a `Point_2` or `Point_3` and a radius, which are all points within the radius of it,
or `std::variant`s of these and of points. Two objects are near if a point of one and a point of the
other are within the bound. So objects that intersect are near, but for an open bound of zero.
Objects may be degenerate, as for `thick_self_intersection_d()`, and the result is that of real
arithmetic. An object of a class that derives from one of these is what its base is, unless
`do_intersect()` takes the class itself: `point_map` may give its base then. Objects of other
classes have traits, a model of `ThickDistanceTraits_d`.

The search takes \f$ O(n \log n + k) \f$ time and \f$ O(n) \f$ space in the plane and in space,
where \f$ k \f$ is the number of pairs \cgalCite{v-riato-03}. In other dimensions, it puts a box on
each point and searches the boxes: see `thick_self_intersection_d()`. So it does with objects:
\f$ K \f$ is then the number of pairs whose bounding boxes are within the bound along each axis. The
algebraic degree is 2 for points and balls; for other objects it is 4 in the plane and 6 in space.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel, the same pairs are reported
in any order. Several threads call the callback at once, so it must allow this. `Parallel_tag`
requires \tbb.

\tparam PointRange is a range of `Point_2`, `Point_3` or `Point_d` of a kernel of \cgal, with
forward iterators or better. It is neither copied nor reordered. It may be a view of C++20, or a
`Point_set_3`.

\tparam NT is a number type as described for `Distance_bound`. It need not be the number type of the
kernel.

\tparam Callback is callable with `(std::size_t i, std::size_t j)`. It returns `void`, or `bool` to
stop the search by returning `false`. Or it is an output iterator for pairs of the type
`std::pair<std::size_t, std::size_t>`; one thread at a time writes to it. Or `with_elements()` has
made it, from a functor of two elements of the range or an output iterator for pairs of them.

\param points the points or objects, all of the same dimension.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param callback is called for each pair, with the positions \f$ i < j \f$ of the two points in the
range, or with the elements at these positions.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the range}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to points}
    \cgalParamDefault{`points.point_map()` if the range has this function, as `Point_set_3` has;
                      otherwise the elements are the points}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of the kernel of the points, or traits of other objects}
    \cgalParamType{a model of `Kernel`, `Kernel_d` or `ThickDistanceTraits_d`}
    \cgalParamDefault{the kernel deduced from the point type}
    \cgalParamExtra{The kernel of the points is accepted as by other functions of \cgal. Other
                    traits decide, whatever the elements are.}
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

\throws std::invalid_argument if a coordinate is NaN or infinite, if the points differ in dimension,
if a radius is negative, NaN or infinite, or if the bound is negative or NaN, before anything is
reported. The message gives the position of the point or object. Exceptions of the callback and of
traits pass through.
\throws std::length_error if there are 2<sup>31</sup> - 1 objects or more, or as many points whose
coordinates are `double` or `float` and whose type tells their dimension.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `with_elements()`
\sa `thick_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(PointRange&& points, const Distance_bound<NT>& bound,
                                 Callback&& callback,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::near_search(bound, np, threads);
  return internal::search_ranges(callback, np, threads, search, points);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of a range whose distance is within a bound, as the version above, and
describes the scene and the search in `profile`.

If `Scene_profile::force_tier()` has forced a tier in `profile`, the search uses this tier. The
search always scans the points again, and refuses a tier that is not exact for them. If only the
answer is wanted, pass a `Scene_profile` without points.

\param points,bound,callback,np as in the version above, but without `geom_traits` for other classes
of objects.
\param profile is replaced by the profile of the points and the bound, with the same tier forced,
and with the numbers of pairs that each kind of arithmetic has decided. It does not change if the
function throws.

\throws std::invalid_argument as the version above, and if the forced tier is not exact for the
scene.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(PointRange&& points, const Distance_bound<NT>& bound,
                                 Callback&& callback, Scene_profile& profile,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::near_search(bound, np, threads, profile);
  return internal::search_ranges(callback, np, threads, search, points);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one range and a point of another whose distance is within a bound,
each exactly once.

Pairs within a range are neither reported nor tested. Otherwise the function is as the version for
one range, where \f$ n \f$ is the number of points of both ranges and \f$ k \f$ is the number of
close pairs of their union.

The ranges may hold objects as well, and of different types: `Point_2` and `Segment_2`, or
`Segment_3` and `Triangle_3`. Traits for objects of other classes have intervals of both types, and
are asked about an object of the first range and one of the second.

\param points_a, points_b the points or objects, all of the same dimension.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param callback is called for each pair with the position \f$ i \f$ of its point in `points_a` and
the position \f$ j \f$ of its point in `points_b`, or with the elements at these positions.
\param np as for the version for one range; the property map is applied to both ranges.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as the version for one range. Positions in the message go on from the
first range to the second range.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(PointRangeA&& points_a, PointRangeB&& points_b,
                                 const Distance_bound<NT>& bound, Callback&& callback,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::near_search(bound, np, threads);
  return internal::search_ranges(callback, np, threads, search, points_a, points_b);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one range and a point of another whose distance is within a bound,
as the version above. The profile is as in the version for one range, for the points of both ranges.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(PointRangeA&& points_a, PointRangeB&& points_b,
                                 const Distance_bound<NT>& bound, Callback&& callback,
                                 Scene_profile& profile,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = internal::near_search(bound, np, threads, profile);
  return internal::search_ranges(callback, np, threads, search, points_a, points_b);
}

#ifndef DOXYGEN_RUNNING
// Bare numbers as bounds: each call that has one stops with a sentence that says so.
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, bool>
fixed_radius_near_neighbors(const Arguments&...)
{
  return Thick_intersection_d::internal::check_bound<Arguments...>();
}
#endif

} // namespace CGAL

#endif // CGAL_FIXED_RADIUS_NEAR_POINTS_H
