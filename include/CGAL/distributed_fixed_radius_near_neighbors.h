// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_FIXED_RADIUS_NEAR_NEIGHBORS_H
#define CGAL_DISTRIBUTED_FIXED_RADIUS_NEAR_NEIGHBORS_H

// All pairs of points within a distance, or the neighbors of each point, of points that are on
// several processes. The only header that needs MPI.

#include <CGAL/Distance_bound.h>
#include <CGAL/Distributed_profile.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/Remote_error.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/distributed/Communicator.h>
#include <CGAL/Thick_intersection_d/internal/distributed/distributed_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/distributed/distributed_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <mpi.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of all processes whose distance is within a bound, each exactly once, on
one process.

All processes of a communicator of MPI call this function together, each with a range of points of
its own, which may be empty. An *id* of a point is the number of points of processes of lower rank
and the position of the point in its range. So the ids are the positions in the ranges put one after
another, and the pairs are those that `fixed_radius_near_neighbors()` reports for that one range:
for every number of processes, every distribution of the points and every kernel, ties included.
Which process reports a pair depends on the input and the number of processes alone.

By default, space is cut into parts of about the same work, one for each process: a box or a few
boxes. Points move to the process of their part, with their ids, and points near another part are
sent there as well: about 34 bytes for each point in space. The process then searches its points as
`fixed_radius_near_neighbors()` does. `Distributed_profile` leaves the points where they are.

The function sends no message on `comm` itself, but on a duplicate of it. Nothing is in flight when
it returns or throws. An error of MPI ends the job.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, the same
one on all processes. In parallel, several threads of a process search its points, and several
threads call the callback at once. Other processes stop the search of this one sooner if MPI was
initialized with `MPI_THREAD_SERIALIZED` or more.

\tparam PointRange is a range of points as for `fixed_radius_near_neighbors()`. Coordinates are of a
rational number type. Coordinates that are doubles travel as doubles, all others as the exact
numbers that they are.

\tparam NT is a number type as described for `Distance_bound`.

\tparam Callback is callable with `(std::uint64_t i, std::uint64_t j)`. It returns `void`, or `bool`
to stop the search of all processes by returning `false`. Or it is an output iterator for pairs of
the type `std::pair<std::size_t, std::size_t>`. It does not communicate.

\param comm an intracommunicator of processes that all call this function.
\param points the points of this process, all of the same dimension on all processes.
\param bound the same bound on all processes.
\param callback is called for each pair that this process finds, with the ids \f$ i < j \f$.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as for
`fixed_radius_near_neighbors()`. The progress is that of the search of this process.

\return on all processes: `false` iff a callback or a progress functor of one process stopped the
search.

\throws Remote_error if another process throws. So if one process throws, all of them throw: that
process its own exception, and all others this one.
\throws std::invalid_argument if a coordinate is NaN or infinite, if the points of this process
differ in dimension, or if the bound is negative or NaN, as `fixed_radius_near_neighbors()`. On all
processes if processes have different bounds or dimensions.
\throws std::length_error if this process has to search 2<sup>31</sup> - 1 points or more.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `fixed_radius_near_neighbors()`
\sa `Distributed_profile`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool distributed_fixed_radius_near_neighbors(
  MPI_Comm comm, PointRange&& points, const Distance_bound<NT>& bound, Callback&& callback,
  const NamedParameters& np = parameters::default_values())
{
  Distributed_profile profile;
  return distributed_fixed_radius_near_neighbors<ConcurrencyTag>(comm, points, bound, callback,
                                                                 profile, np);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of all processes whose distance is within a bound, as the version above,
with points distributed as `profile` says.

\param comm,points,bound,callback,np as in the version above.
\param profile says how to distribute the points, the same on all processes, and then holds what the
search has done on this process.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool distributed_fixed_radius_near_neighbors(
  MPI_Comm comm, PointRange&& points, const Distance_bound<NT>& bound, Callback&& callback,
  Distributed_profile& profile, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Communicator together(comm);
  return internal::search_distributed_ranges(together, bound, callback, profile, np,
                                             internal::Threads(ConcurrencyTag()), points);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one set and a point of another whose distance is within a bound,
each exactly once, on one process. Both sets are on all processes.

Points of each set have ids as in the version for one set. Pairs within a set are not reported.
Otherwise the function is as the version for one set.

\param comm an intracommunicator of processes that all call this function.
\param points_a, points_b the points of this process in each set, of the same type and dimension.
\param bound the same bound on all processes.
\param callback is called for each pair with the id \f$ i \f$ of its point in the first set and the
id \f$ j \f$ of its point in the second set.
\param np as for the version for one set.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool distributed_fixed_radius_near_neighbors(
  MPI_Comm comm, PointRangeA&& points_a, PointRangeB&& points_b, const Distance_bound<NT>& bound,
  Callback&& callback, const NamedParameters& np = parameters::default_values())
{
  Distributed_profile profile;
  return distributed_fixed_radius_near_neighbors<ConcurrencyTag>(comm, points_a, points_b, bound,
                                                                 callback, profile, np);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one set and a point of another whose distance is within a bound, as
the version above, with points distributed as `profile` says.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool distributed_fixed_radius_near_neighbors(
  MPI_Comm comm, PointRangeA&& points_a, PointRangeB&& points_b, const Distance_bound<NT>& bound,
  Callback&& callback, Distributed_profile& profile,
  const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Communicator together(comm);
  return internal::search_distributed_ranges(together, bound, callback, profile, np,
                                             internal::Threads(ConcurrencyTag()), points_a,
                                             points_b);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of this process all other points of all processes whose distance is within a
bound, as ids.

All processes of a communicator of MPI call this function together, as
`distributed_fixed_radius_near_neighbors()`. Each process gets the lists of the points of its own
range, in their order, wherever the neighbors are and whichever processes have found them. They are
the lists that `fixed_radius_neighbor_lists()` returns for the ranges of all processes put one after
another: for every number of processes, every distribution of the points and every kernel, ties
included. The result does not depend on the number of threads.

Beside what the search for pairs sends, each neighbor that is found by another process than the one
that has the point takes 8 bytes, and each part of a list 16 more.

The parameters, exceptions and messages are those of `distributed_fixed_radius_near_neighbors()`.

\return the lists of the points of this process. As their neighbors may be on other processes,
`Distributed_neighbor_lists::number_of_pairs()` counts all neighbors: its sum over all processes is
twice the number of pairs. If a progress functor cancels the search on one process, it stops on all
of them. The lists then hold some of the pairs, each in both of its lists.

\sa `fixed_radius_neighbor_lists()`
\sa `Distributed_profile`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Distributed_neighbor_lists distributed_fixed_radius_neighbor_lists(
  MPI_Comm comm, PointRange&& points, const Distance_bound<NT>& bound,
  const NamedParameters& np = parameters::default_values())
{
  Distributed_profile profile;
  return distributed_fixed_radius_neighbor_lists<ConcurrencyTag>(comm, points, bound, profile, np);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of this process all other points of all processes whose distance is within a
bound, as the version above, with points distributed as `profile` says. Then `profile` holds what
the search has done on this process.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Distributed_neighbor_lists distributed_fixed_radius_neighbor_lists(
  MPI_Comm comm, PointRange&& points, const Distance_bound<NT>& bound,
  Distributed_profile& profile, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Communicator together(comm);
  return internal::collect_distributed_neighbors(together, bound, profile, np,
                                                 internal::Threads(ConcurrencyTag()), points);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of the first set that this process has all points of a second set whose
distance is within a bound. Both sets are on all processes.

Points of each set have ids as in `distributed_fixed_radius_near_neighbors()`. The lists are those
of the points of `points_a`, and hold ids of the second set. Otherwise the function is as the
version for one set.

\return the lists. If a progress functor cancels the search on one process, they hold some of the
pairs.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Distributed_neighbor_lists distributed_fixed_radius_neighbor_lists(
  MPI_Comm comm, PointRangeA&& points_a, PointRangeB&& points_b, const Distance_bound<NT>& bound,
  const NamedParameters& np = parameters::default_values())
{
  Distributed_profile profile;
  return distributed_fixed_radius_neighbor_lists<ConcurrencyTag>(comm, points_a, points_b, bound,
                                                                 profile, np);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of the first set that this process has all points of a second set whose
distance is within a bound, as the version above, with points distributed as `profile` says.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Distributed_neighbor_lists distributed_fixed_radius_neighbor_lists(
  MPI_Comm comm, PointRangeA&& points_a, PointRangeB&& points_b, const Distance_bound<NT>& bound,
  Distributed_profile& profile, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const internal::Communicator together(comm);
  return internal::collect_distributed_neighbors(together, bound, profile, np,
                                                 internal::Threads(ConcurrencyTag()), points_a,
                                                 points_b);
}

#ifndef DOXYGEN_RUNNING
// Bare numbers as bounds: each call that has one stops with a sentence that says so.
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, bool>
distributed_fixed_radius_near_neighbors(MPI_Comm, const Arguments&...)
{
  return Thick_intersection_d::internal::check_bound<Arguments...>();
}
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>,
                 Distributed_neighbor_lists>
distributed_fixed_radius_neighbor_lists(MPI_Comm, const Arguments&...)
{
  Thick_intersection_d::internal::check_bound<Arguments...>();
  return {};
}
#endif

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_FIXED_RADIUS_NEAR_NEIGHBORS_H
