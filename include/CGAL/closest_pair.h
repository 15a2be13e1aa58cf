// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_CLOSEST_PAIR_H
#define CGAL_CLOSEST_PAIR_H

// The closest pair of points, and a pair of points within a distance.

#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/closest_pair/find_closest_pair.h>
#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

returns the positions of two points of a range whose distance is the least.

The search gives the result of real arithmetic on the given coordinates, for every kernel,
`Simple_cartesian<double>` included. If several pairs have the least distance, the result is the
lexicographically smallest pair of positions, with any number of threads and any seed. Equal points
at different positions are a pair, at distance zero.

In the plane and in space the search takes expected \f$ O(n) \f$ time, for points of any scales. The
closest pair of a random sample bounds how far to look \cgalCite{r-pa-76}, and few points have
another point so near. If doubles cannot bound the least distance, because they are too coarse for
the coordinates, and in other dimensions, the search is the divide and conquer of
\cgalCite{l-cp}. In fixed dimension the search takes \f$ O(n \log n) \f$ time in the worst case, but
for equal points, which are found by hashing: it is then the expected time for each input. The
search uses \f$ O(n) \f$ space. The algebraic degree is 2.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`.
`Parallel_tag` requires \tbb.

\tparam PointRange is a range of `Point_2`, `Point_3` or `Point_d` of a kernel of \cgal, with
forward iterators or better. It is neither copied nor reordered. It may be a view of C++20, or a
`Point_set_3`.

\param points the points, all of the same dimension, at least two and less than
\f$ 2^{31} - 1 \f$ points.
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
    \cgalParamDescription{an instance of the kernel of the points}
    \cgalParamType{a model of `Kernel` or `Kernel_d`}
    \cgalParamDefault{the kernel deduced from the point type}
    \cgalParamExtra{Accepted as by other functions of \cgal. The type of the points determines the
                    kernel.}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the random numbers, which the time depends on}
    \cgalParamType{unsigned int}
    \cgalParamDefault{a seed that each process draws once, so that no input is made for it}
    \cgalParamExtra{The result does not depend on the seed, unless the search is canceled.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor that is called with the progress between 0 and 1, and cancels
                          the search by returning `false`}
    \cgalParamType{a functor with `bool operator()(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{In parallel, one thread at a time calls it, but not always the same thread. The
                    last value is 1 unless it cancels. The check of the points comes before the
                    first call. Nothing interrupts sorting.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the two positions, the smaller position first. If the progress functor cancels the search,
they are the closest of the pairs that were compared so far. (0, 1) is the first of these pairs.

\throws std::invalid_argument if there are fewer than two points, if a coordinate is NaN or
infinite, or if the points differ in dimension. The message gives the position of the point.
Exceptions of the progress functor pass through.
\throws std::length_error if there are \f$ 2^{31} - 1 \f$ points or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `find_close_pair()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<std::size_t, std::size_t>
closest_pair(PointRange&& points, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  using Range = std::remove_reference_t<PointRange>;
  if constexpr(internal::check_range_of_points<Range, NamedParameters>())
    return internal::find_closest_pair(internal::make_elements(points, np), np,
                                       internal::Threads(ConcurrencyTag()));
  else
    return {};
}

/*!
\ingroup PkgThickIntersectionDRef

returns the positions of two points of a range whose distance is within a bound, if there are any.

The search stops at the first such pair. It gives the answer of real arithmetic, as
`fixed_radius_near_neighbors()` does, for distances of exactly the bound and for bounds of any size
as well. Equal points at different positions are a pair.

In the plane and in space, the search joins points in common cells: a few points first, and then all
of them. It falls back to the search of `fixed_radius_near_neighbors()` if cells are crowded, and to
the buckets of \cgalCite{l-cp} if doubles are too coarse for the bound, and in other dimensions. A
bucket holds the points of a cell as large as the bound. Two points of a bucket are
closer than the bound if it holds more than 4 points in the plane, more than 8 in space, or more
than \f$ (\lfloor \sqrt d \rfloor + 1)^d \f$ in dimension \f$ d \f$. These numbers serve closed
bounds and open bounds. The search takes
expected \f$ O(n) \f$ time in fixed dimension if the coordinates are doubles, or if the extent of
the scene is below \f$ 2^{30} \f$ times the bound. Otherwise it sorts the coordinates, and takes
\f$ O(n \log n) \f$ time. Beyond dimension 5 it is the divide and conquer of `closest_pair()`. The
search uses \f$ O(n) \f$ space. The algebraic degree is 2.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the pair depends on the input alone. `Parallel_tag` requires \tbb.

\tparam PointRange is a range as for `closest_pair()`.

\tparam NT is a number type as described for `Distance_bound`. It need not be the number type of the
kernel.

\param points the points, all of the same dimension, less than \f$ 2^{31} - 1 \f$ points.
\param bound made by `within_distance()` or `within_squared_distance()`.
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
    \cgalParamDescription{an instance of the kernel of the points}
    \cgalParamType{a model of `Kernel` or `Kernel_d`}
    \cgalParamDefault{the kernel deduced from the point type}
    \cgalParamExtra{Accepted as by other functions of \cgal. The type of the points determines the
                    kernel.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor that is called with the progress between 0 and 1, and cancels
                          the search by returning `false`}
    \cgalParamType{a functor with `bool operator()(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{In parallel, one thread at a time calls it, but not always the same thread. The
                    last value is 1 unless it cancels. The check of the points comes before the
                    first call. Nothing interrupts sorting.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the two positions, the smaller position first. Returns nothing if no two points are within
the bound, or if the progress functor cancels the search before it has found a pair.

\throws std::invalid_argument if a coordinate is NaN or infinite, if the points differ in dimension,
or if the bound is negative or NaN. All points are checked, wherever the pair is. Exceptions of the
progress functor pass through.
\throws std::length_error if there are \f$ 2^{31} - 1 \f$ points or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `closest_pair()`
\sa `fixed_radius_near_neighbors()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
std::optional<std::pair<std::size_t, std::size_t>>
find_close_pair(PointRange&& points, const Distance_bound<NT>& bound,
                const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  using Range = std::remove_reference_t<PointRange>;
  if constexpr(internal::check_range_of_points<Range, NamedParameters>())
    return internal::find_pair_within(internal::make_elements(points, np), bound, np,
                                      internal::Threads(ConcurrencyTag()));
  else
    return {};
}

/*!
\ingroup PkgThickIntersectionDRef

returns whether two points of a range are within a bound: whether `find_close_pair()` finds a pair.

If the progress functor cancels the search, the answer is `true` if a pair was found, and `false`
otherwise.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
bool has_close_pair(PointRange&& points, const Distance_bound<NT>& bound,
                    const NamedParameters& np = parameters::default_values())
{
  return find_close_pair<ConcurrencyTag>(points, bound, np).has_value();
}

#ifndef DOXYGEN_RUNNING
// Bare numbers as bounds: each call that has one stops with a sentence that says so.
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>,
                 std::optional<std::pair<std::size_t, std::size_t>>>
find_close_pair(const Arguments&...)
{
  Thick_intersection_d::internal::check_bound<Arguments...>();
  return {};
}
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, bool>
has_close_pair(const Arguments&...)
{
  return Thick_intersection_d::internal::check_bound<Arguments...>();
}
#endif

} // namespace CGAL

#endif // CGAL_CLOSEST_PAIR_H
