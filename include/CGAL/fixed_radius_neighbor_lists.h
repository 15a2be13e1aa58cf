// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FIXED_RADIUS_NEIGHBOR_LISTS_H
#define CGAL_FIXED_RADIUS_NEIGHBOR_LISTS_H

// For each point, a list of all points within a distance.

#include <CGAL/Distance_bound.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/tags.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/lists/neighbor_lists_search.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/objects/near_objects_search.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of a range all other points whose distance is within a bound.

The search takes \f$ O(n \log n + k \log k) \f$ time and \f$ O(n + k) \f$ space in the plane and in
space, where \f$ k \f$ is the number of pairs \cgalCite{v-riato-03}. In other dimensions, and of
objects, it takes the time of `fixed_radius_near_neighbors()` and \f$ O(k \log k) \f$. The result
does not depend on the number of threads.

The parameters are as for `fixed_radius_near_neighbors()`: the points may be objects. The lists hold
positions.

\return the lists. If the progress functor cancels the search, they hold some of the pairs, each in
both of its lists.

\throws std::invalid_argument as `fixed_radius_near_neighbors()`.
\throws std::length_error as `fixed_radius_near_neighbors()`, and if there are \f$ 2^{32} \f$ points
or more.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Neighbor_lists fixed_radius_neighbor_lists(PointRange&& points,
                                           const Distance_bound<NT>& bound,
                                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  Neighbor_lists lists;
  internal::collect_neighbors(lists, bound, np, internal::Threads(ConcurrencyTag()), points);
  return lists;
}

/*!
\ingroup PkgThickIntersectionDRef

replaces lists by those of the version above, in the memory that they have. So a loop that makes
lists of points that move gets this memory once. New memory may take as long as the search, because
the system hands out and clears each page anew.

\param points,bound,np as in the version above.
\param lists are replaced, whatever points they are of. They do not change if the function throws,
unless memory runs out: then they can only be replaced or destroyed.

\return `false` iff the progress functor stopped the search.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_neighbor_lists(PointRange&& points, const Distance_bound<NT>& bound,
                                 Neighbor_lists& lists,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::collect_neighbors(lists, bound, np, internal::Threads(ConcurrencyTag()),
                                     points);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of a range all points of another range whose distance is within a bound.

The lists are those of the points of `points_a`, and hold positions in `points_b`. Otherwise the
function is as the version for one range, where \f$ n \f$ is the number of points of both ranges and
\f$ k \f$ is the number of close pairs of their union.

\return the lists. If the progress functor cancels the search, they hold some of the pairs.

\throws std::invalid_argument as `fixed_radius_near_neighbors()`.
\throws std::length_error as `fixed_radius_near_neighbors()`, and if both ranges together have
\f$ 2^{32} \f$ points or more.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Neighbor_lists fixed_radius_neighbor_lists(PointRangeA&& points_a, PointRangeB&& points_b,
                                           const Distance_bound<NT>& bound,
                                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  Neighbor_lists lists;
  internal::collect_neighbors(lists, bound, np, internal::Threads(ConcurrencyTag()), points_a,
                              points_b);
  return lists;
}

/*!
\ingroup PkgThickIntersectionDRef

replaces lists by those of the version above, in the memory that they have. The parameter `lists`
and the result are as in the version for one range.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_neighbor_lists(PointRangeA&& points_a, PointRangeB&& points_b,
                                 const Distance_bound<NT>& bound, Neighbor_lists& lists,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  return internal::collect_neighbors(lists, bound, np, internal::Threads(ConcurrencyTag()),
                                     points_a, points_b);
}

#ifndef DOXYGEN_RUNNING
// Bare numbers as bounds: each call that has one stops with a sentence that says so.
template <class ConcurrencyTag = Sequential_tag, class... Arguments>
std::enable_if_t<Thick_intersection_d::internal::has_bare_number_v<Arguments...>, Neighbor_lists>
fixed_radius_neighbor_lists(const Arguments&...)
{
  Thick_intersection_d::internal::check_bound<Arguments...>();
  return {};
}
#endif

} // namespace CGAL

#endif // CGAL_FIXED_RADIUS_NEIGHBOR_LISTS_H
