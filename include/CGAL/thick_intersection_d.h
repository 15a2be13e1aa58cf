// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_H
#define CGAL_THICK_INTERSECTION_D_H

// All intersecting pairs of objects, in one range or between two ranges.

#include <CGAL/Element_callback.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_object_traits_d.h>
#include <CGAL/interiors.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/object_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/reports/pair_search.h>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of objects of a range that intersect, each exactly once.

The algorithm is the divide and conquer of Vigneron \cgalCite{v-riato-03} along the axes, with a
sweep where a single axis is left. It takes \f$ O(n) \f$ space. The traits decide about the time, in
fixed dimension \f$ d \f$:

- *Intervals.* Objects of a kernel, thickened or not, and objects whose traits are a model of
  `ThickIntersectionIntervalTraits_d` have boxes. The boxes may have any sizes. The search takes
  \f$ O(n \log^{d-1} n + K) \f$ time, where \f$ K \f$ is the number of pairs whose boxes meet. Only
  these pairs are tested. Boxes have up to eight axes, or up to four if only the objects know their
  dimension.
- *Three predicates.* Objects of other traits are compared by the predicates of
  `ThickIntersectionTraits_d`. For objects of diameter at most \f$ D \f$ and volume at least
  \f$ V \f$ the search takes \f$ O(n \log n + \frac{D^d}{V}(n + k)) \f$ time, where \f$ k \f$ is
  the number of reported pairs. Objects that are not thick are reported correctly too, but may take
  more time.

Balls of one radius are searched as points, in \f$ O(n \log n + k) \f$ time.

An object is never paired with itself. Equal objects at different positions are a pair if they
intersect. The search gives the result of real arithmetic if the predicates of the traits are exact,
as the predicates of the package are: on the coordinates that the objects hold, for every kernel,
`Simple_cartesian<double>` included, and in every rounding mode. Objects of a kernel are closed, so
objects that touch intersect. They may be degenerate: a segment of length zero is the point that it
is, a flat triangle a segment or a point, and a flat tetrahedron a polygon, a segment or a point.
`interiors()` makes objects open, so that those that only touch are no pair.
The algebraic degree is 2 in the plane and 3 in space, and with radii 4 in the plane and 6 in space,
or 2 for balls and points alone; the `Scene_profile` tells what it takes.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel, the same pairs are reported
in any order. Several threads call the callback at once, so it must allow this. `Parallel_tag`
requires \tbb.

\tparam ObjectRange is a range whose elements are of the type `Object_d` of the traits, with forward
iterators or better. It is neither copied nor reordered. It may be a view of C++20. Without traits,
the elements are objects of a kernel, boxes of the type `Bbox_2` or `Bbox_3`, objects of classes
that derive from these, which are what their base is, `std::pair`s of such an object and a radius,
which are thickened by the radius, other objects with `bbox()` and `do_intersect()`, or
`std::variant`s of such types, all in the plane or all in space.

\tparam Callback is callable with `(std::size_t i, std::size_t j)`. It returns `void`, or `bool` to
stop the search by returning `false`. Or it is an output iterator for pairs of the type
`std::pair<std::size_t, std::size_t>`; one thread at a time writes to it. Or `with_elements()` has
made it, from a functor of two elements of the range or an output iterator for pairs of them.

\param objects the objects, or `interiors()` of them: without their boundaries.
\param callback is called for each pair, with the positions \f$ i < j \f$ of the two objects in the
range, or with the elements at these positions.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a traits class, which may have a state}
    \cgalParamType{a model of `ThickIntersectionIntervalTraits_d` or of `ThickIntersectionTraits_d`}
    \cgalParamDefault{`Thick_object_traits_d<Object>`}
    \cgalParamExtra{Intervals are used if the class is a model of both.}
  \cgalParamNEnd
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating objects to the elements of the range}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to objects}
    \cgalParamDefault{the elements are the objects}
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

\throws std::invalid_argument if a coordinate or radius of an object is NaN or infinite, or if a
radius is negative, before anything is reported. The message gives the position of the object. Exact
numbers beyond the range of doubles are taken. Traits of one's own may check their objects in a
member function `check(object, position)`. Exceptions of the callback and of predicates pass
through.
\throws std::invalid_argument if an interval is empty or NaN, before anything is reported.
\throws std::length_error if there are 2<sup>31</sup> - 1 objects or more, and they are searched by
intervals.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `thick_intersection_d()`
\sa `with_elements()`
\sa `fixed_radius_near_neighbors()`
*/
template <class ConcurrencyTag = Sequential_tag, class ObjectRange, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool thick_self_intersection_d(ObjectRange&& objects, Callback&& callback,
                               const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = [&](const auto& elements, const auto& sets, auto& report) {
    return internal::report_object_pairs(elements, sets, report, np, threads);
  };
  return internal::search_ranges<internal::takes_interiors>(callback, np, threads, search, objects);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of objects of a range that intersect, as the version above, and describes the
scene and the search in `profile`.

If `Scene_profile::force_tier()` has forced a tier in `profile`, the search uses this tier, and
refuses it if it is not exact for the objects. If only the answer is wanted, pass a `Scene_profile`
without objects. The search takes one more pass over the objects, and counts pairs one by one.

\param objects,callback,np as in the version above, without `geom_traits`. The objects are of a
kernel or boxes, thickened by a radius or not, or variants of them.
\param profile is replaced by the profile of the objects, with the same tier forced, and with the
numbers of pairs that each kind of arithmetic has decided. It does not change if the function
throws.

\throws std::invalid_argument as the version above, and if the forced tier is not exact for the
scene.
*/
template <class ConcurrencyTag = Sequential_tag, class ObjectRange, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool thick_self_intersection_d(ObjectRange&& objects, Callback&& callback, Scene_profile& profile,
                               const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = [&](const auto& elements, const auto& sets, auto& report) {
    return internal::report_object_pairs(elements, sets, report, profile, np, threads);
  };
  return internal::search_ranges<internal::takes_interiors>(callback, np, threads, search, objects);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of an object of one range and an object of another that intersect, each exactly
once.

Pairs within a range are neither reported nor tested. Otherwise the function is as
`thick_self_intersection_d()`, where \f$ n \f$ is the number of objects of both ranges. With
intervals, \f$ K \f$ is the number of pairs between the two ranges whose boxes meet. Without traits,
long segments of one range are searched in up to 64 stretches with boxes of their own, where fewer
pairs of boxes are expected to meet: rays among many small triangles take about as long as there are
stretches and triangles. With three predicates, \f$ k \f$ is the number of intersecting pairs of the
union of the ranges.

The two ranges may hold objects of different types, such as `Segment_3` and `Triangle_3`. Without
traits, both are types that `thick_self_intersection_d()` takes without traits. For two types of
which one is not of the package, the test is `do_intersect(a, b)`, found in the namespace of one of
them, for an object of the first range and one of the second. Given traits are a model of
`ThickIntersectionIntervalTraits_d` for both types.

\param objects_a, objects_b the objects. One of them, or both, may be `interiors()` of objects.
\param callback is called for each pair with the position \f$ i \f$ of its object in `objects_a` and
the position \f$ j \f$ of its object in `objects_b`, or with the elements at these positions.
\param np as for `thick_self_intersection_d()`; a property map is applied to both ranges.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as `thick_self_intersection_d()`. Positions in the message go on from
the first range to the second range.

\sa `thick_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class ObjectRangeA, class ObjectRangeB,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool thick_intersection_d(ObjectRangeA&& objects_a, ObjectRangeB&& objects_b,
                          Callback&& callback,
                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = [&](const auto& elements, const auto& sets, auto& report) {
    return internal::report_object_pairs(elements, sets, report, np, threads);
  };
  return internal::search_ranges<internal::takes_interiors>(callback, np, threads, search,
                                                            objects_a, objects_b);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of an object of one range and an object of another that intersect, as the version
above, and describes the scene of both ranges and the search in `profile`.

\param objects_a,objects_b,callback,np as in the version above, without `geom_traits`.
\param profile as for `thick_self_intersection_d()`.

\throws std::invalid_argument as the version above, and if the forced tier is not exact for the
scene.
*/
template <class ConcurrencyTag = Sequential_tag, class ObjectRangeA, class ObjectRangeB,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool thick_intersection_d(ObjectRangeA&& objects_a, ObjectRangeB&& objects_b, Callback&& callback,
                          Scene_profile& profile,
                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Threads threads{ConcurrencyTag()};
  const auto search = [&](const auto& elements, const auto& sets, auto& report) {
    return internal::report_object_pairs(elements, sets, report, profile, np, threads);
  };
  return internal::search_ranges<internal::takes_interiors>(callback, np, threads, search,
                                                            objects_a, objects_b);
}

} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_H
