// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_EXTERNAL_FIXED_RADIUS_NEAR_NEIGHBORS_H
#define CGAL_EXTERNAL_FIXED_RADIUS_NEAR_NEIGHBORS_H

// All pairs of points within a distance, of more points than the memory holds.

#include <CGAL/Distance_bound.h>
#include <CGAL/Memory_budget.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/external/external_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of a range whose distance is within a bound, each exactly once, within a
budget of memory. The points that do not fit are written to a scratch file.

The pairs are those of `fixed_radius_near_neighbors()`, in another order. The search passes over the
range once, and holds only some of its points at a time. So the elements of the range may be made
when they are read, as from a file: the range need not be in memory. A chapter of the manual,
\ref thickBeyondMemory, shows such a range.

The budget is for the data of the search, which may exceed it by up to a tenth; by up to three
fifths if very many pairs are about as far apart as the bound, as in a lattice. It covers neither
the program itself nor what the range and the callback hold. The scratch file takes 32 bytes per
point in space and 24 in the plane, and up to as many for points near the borders of parts. It has
no name, so it vanishes with the process, however that ends; on systems where an open file keeps its
name, the search removes it.

If all points fit in the budget, they are searched at once, and nothing is written. Otherwise the
search takes \f$ O(n \log n + k) \f$ time if most points are farther than the bound from the borders
of parts that fit in the budget.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input and the budget alone. In parallel, the same
pairs are reported in any order. Several threads call the callback at once, so it must allow this.
`Parallel_tag` requires \tbb.

\tparam PointRange is a range of `Point_2` or `Point_3` of a kernel of \cgal whose number type is
`double`, or one whose numbers doubles hold, with input iterators that can be copied, or better.
`begin()` is called once.

\tparam NT is a number type as described for `Distance_bound`.

\tparam Callback is callable with `(std::uint64_t i, std::uint64_t j)`. It returns `void`, or `bool`
to stop the search by returning `false`.

\param points the points.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param budget the memory, at least 4 MiB, and the folder of the scratch file.
\param callback is called for each pair, with the positions \f$ i < j \f$ of the two points in the
range.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the range}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to points}
    \cgalParamDefault{`points.point_map()` if the range has this function, as `Point_set_3` has;
                      otherwise the elements are the points}
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

\throws std::invalid_argument if a coordinate is NaN or infinite, if the bound is negative or NaN,
or if the budget is less than 4 MiB, before anything is reported. Exceptions of the range
and the callback pass through.
\throws std::length_error if a crowd of points does not fit in the budget: a part of the points is
searched with all points within the bound of it, as measured along the axes, and even small parts
have too many of them. Pairs may have been reported.
\throws std::system_error if the scratch file cannot be made, written or read, as when the disk is
full. Pairs may have been reported.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `fixed_radius_near_neighbors()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool external_fixed_radius_near_neighbors(PointRange&& points, const Distance_bound<NT>& bound,
                                          const Memory_budget& budget, Callback&& callback,
                                          const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::search_externally(points, bound, budget, callback, np,
                                     internal::Threads(ConcurrencyTag()));
}

#ifndef DOXYGEN_RUNNING
// Bare numbers as bounds: each call that has one stops with a sentence that says so.
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, bool>
external_fixed_radius_near_neighbors(const Arguments&...)
{
  return Thick_intersection_d::internal::check_bound<Arguments...>();
}
#endif

} // namespace CGAL

#endif // CGAL_EXTERNAL_FIXED_RADIUS_NEAR_NEIGHBORS_H
