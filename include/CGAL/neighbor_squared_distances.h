// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_NEIGHBOR_SQUARED_DISTANCES_H
#define CGAL_NEIGHBOR_SQUARED_DISTANCES_H

// The squared distances of the neighbors in lists.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Neighbor_lists.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/lists/neighbor_distances.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgThickIntersectionDRef

computes the squared distances of all neighbors in lists, in the order of the lists.

The distances are an array beside `Neighbor_lists::positions()`: the element `k` belongs to
`lists.positions()[k]`, and the neighbors of point `i` have the elements `lists.begins()[i]` up to
but excluding `lists.begins()[i + 1]`.

The function computes in the number type `FT` of the kernel, one distance after another, so the
result is exact if this number type is. With `double`, each difference, square and sum is rounded:
the result for a pair at exactly the bound may be a little larger than the squared bound. It takes
\f$ O(n + k) \f$ time and space for \f$ n \f$ points and \f$ k \f$ neighbors. Several threads may
call it at once for the same lists and points, if the number type allows this.

\tparam PointRange is a range of points as for `fixed_radius_near_neighbors()`.

\param lists made from `points` by `fixed_radius_neighbor_lists()`, or otherwise.
\param points the points.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the range}
    \cgalParamType{a model of `ReadablePropertyMap` from these elements to points}
    \cgalParamDefault{`points.point_map()` if the range has this function, as `Point_set_3` has;
                      otherwise the elements are the points}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a `std::vector` of the type of the Cartesian coordinates of the points.

\throws std::invalid_argument if there are not as many lists as points, or if a list has a position
of no point.
*/
template <class PointRange, class CGAL_NP_TEMPLATE_PARAMETERS>
auto neighbor_squared_distances(const Neighbor_lists& lists, PointRange&& points,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Thick_intersection_d::internal::compute_neighbor_distances(lists, np, points);
}

/*!
\ingroup PkgThickIntersectionDRef

computes the squared distances of all neighbors in lists of two ranges, in the order of the lists.

The lists are those of the points of `points_a`, and hold positions in `points_b`. Otherwise the
function is as the version for one range. The points of both ranges have the same type.
*/
template <class PointRangeA, class PointRangeB, class CGAL_NP_TEMPLATE_PARAMETERS,
          class = std::enable_if_t<!Thick_intersection_d::internal::are_named_parameters_v<
            std::decay_t<PointRangeB>>>>
auto neighbor_squared_distances(const Neighbor_lists& lists, PointRangeA&& points_a,
                                PointRangeB&& points_b,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return Thick_intersection_d::internal::compute_neighbor_distances(lists, np, points_a, points_b);
}

} // namespace CGAL

#endif // CGAL_NEIGHBOR_SQUARED_DISTANCES_H
