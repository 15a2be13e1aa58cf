// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_PERIODIC_CLOSEST_PAIR_H
#define CGAL_PERIODIC_CLOSEST_PAIR_H

// The closest pair of images of points in a domain that repeats.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Periodic_lattice_d.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/periodic/periodic_closest_pair_search.h>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

returns the closest pair of images of points in a domain that repeats: `(i, j, offset)` as
`periodic_fixed_radius_near_neighbors()` reports it, in a
`std::tuple<std::size_t, std::size_t, std::array<int, d> >`.

Of pairs that are as close, it is the lexicographically smallest. One point is enough if an axis
repeats: then it and an image of it may be the closest pair. The result is that of real arithmetic,
whatever the kernel.

The search takes expected \f$ O(n \log n) \f$ time: the closest pair of the points without periods
and the shortest period bound the distance, and few pairs of images are within this bound
\cgalCite{l-cp}. It takes \f$ O(n) \f$ space.

\tparam ConcurrencyTag, PointRange, Domain as for `periodic_fixed_radius_near_neighbors()`.

\param points,domain as for `periodic_fixed_radius_near_neighbors()`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map`,
`geom_traits` and `callback`, as for `fixed_radius_near_neighbors()`.

\return the pair and the offset, the same for any number of threads. If the progress functor cancels
the search, they are those of the closest of the pairs that it has seen so far.

\throws std::invalid_argument as `periodic_fixed_radius_near_neighbors()`, if there is no pair, that
is, if there are no points, or if there is one point and nothing repeats, and if the closest pair is
farther apart than the largest double.
\throws std::length_error, std::runtime_error as `periodic_fixed_radius_near_neighbors()`.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class Domain,
          class NamedParameters = parameters::Default_named_parameters>
auto periodic_closest_pair(PointRange&& points, const Domain& domain,
                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::find_periodic_closest_pair(domain, np, internal::Threads(ConcurrencyTag()),
                                              points);
}

} // namespace CGAL

#endif // CGAL_PERIODIC_CLOSEST_PAIR_H
