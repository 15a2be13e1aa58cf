// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FIXED_RADIUS_NEAR_NEIGHBORS_H
#define CGAL_FIXED_RADIUS_NEAR_NEIGHBORS_H

// All pairs of points within a distance, of one range or between two.

#include <CGAL/Distance_bound.h>
#include <CGAL/Neighbor_lists.h>
#include <CGAL/Scene_profile.h>
#include <CGAL/Thick_point_traits_d.h>

#include <CGAL/Thick_intersection_d/internal/input/Numbered_elements.h>
#include <CGAL/Thick_intersection_d/internal/reports/Neighbor_collector.h>
#include <CGAL/Thick_intersection_d/internal/doors/object_pairs_search.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_route.h>

#include <limits>
#include <optional>
#include <stdexcept>

namespace CGAL {

namespace Thick_intersection_d {
namespace internal {

// Whether the slab route can take a scene: it needs coordinates that are doubles with a finite
// error, and keeps positions in 32 bits, one of which is room for more.
inline bool fits_slabs(const Scene_profile& profile)
{
  for(int axis = 0; axis < profile.dimension(); ++axis)
    if(!std::isfinite(profile.range(axis).first) || !std::isfinite(profile.range(axis).second))
      return false;
  return profile.size() < (std::numeric_limits<Place>::max)() / 2;
}

// Searches by slabs. Returns false iff the search was stopped.
template <class Route, class Callback, class NamedParameters>
bool report_by_slabs(const Route& route, std::size_t size,
                     std::optional<std::size_t> first_set_size, Callback& callback,
                     const NamedParameters& np)
{
  auto progress = make_progress(np, size);
  if(!first_set_size) {
    Pair_reporter<Callback> report(callback);
    return route.search(report, progress);
  }
  const auto callback_of_two_sets
    = [&](std::size_t i, std::size_t j) { return callback(i, j - *first_set_size); };
  Pair_reporter<decltype(callback_of_two_sets)> report(callback_of_two_sets);
  return route.search(*first_set_size, report, progress);
}

// Searches points in the plane or in space by slabs, along the axes along which they differ, at
// least two; others by the book.
template <class ConcurrencyTag, class Elements, class Callback, class NamedParameters>
bool search_near_pairs(const Elements& points, std::optional<std::size_t> first_set_size,
                       Doubles<Elements>& doubles, double error, const Scene_profile& profile,
                       const Thick_point_traits_d<typename Elements::value_type>& traits,
                       Callback& callback, const NamedParameters& np)
{
  using Point = typename Elements::value_type;
  [[maybe_unused]] const auto search_slabs = [&](auto dimension) {
    constexpr int axes = decltype(dimension)::value;
    doubles.keep(searched_axes<axes>(profile));
    const auto is_within = traits.do_intersect_d_object();
    const Slab_route<ConcurrencyTag, axes, Elements> route(points, doubles, error, profile,
                                                           is_within);
    return report_by_slabs(route, points.size(), first_set_size, callback, np);
  };
  const int dimension = profile.dimension();
  if((dimension == 2 || dimension == 3) && fits_slabs(profile)) {
    if constexpr(dimension_or<Point>(3) == 3)
      if(profile.extended_axes() == 3)
        return search_slabs(std::integral_constant<int, 3>());
    if constexpr(dimension_or<Point>(2) == 2 || dimension_or<Point>(3) == 3)
      return search_slabs(std::integral_constant<int, 2>());
  }
  return report_intersections<ConcurrencyTag>(points, first_set_size, traits, callback, np);
}

// If `description` is not null, takes the tier that is forced there, and leaves the profile of the
// scene there.
template <class ConcurrencyTag, class Elements, class NT, class Callback, class NamedParameters>
bool report_near_pairs(const Elements& points, std::optional<std::size_t> first_set_size,
                       const Distance_bound<NT>& bound, Callback& callback,
                       const NamedParameters& np, Scene_profile* description = nullptr)
{
  using Point = typename Elements::value_type;
  using Number = Coordinate_t<Point>;
  const Squared_bound<Exact_number_t<Number>> squared_bound(bound);
  Doubles<Elements> doubles(points);
  const Coordinate_scan scan = scan_coordinates<ConcurrencyTag>(
    points, "point",
    [&](std::size_t position, int axis, double x) { doubles.set(position, axis, x); });
  Scene_profile profile = make_profile(points.size(), scan, squared_bound);
  if(description != nullptr && description->forced_tier())
    profile.force_tier(*description->forced_tier());

  Shared_decision_counts counts;
  bool is_complete = true;
  if(points.size() != 0) {
    const Thick_point_traits_d<Point> traits(squared_bound, profile,
                                             description != nullptr ? &counts : nullptr);
    is_complete = search_near_pairs<ConcurrencyTag>(points, first_set_size, doubles, scan.error,
                                                    profile, traits, callback, np);
  }
  if(description != nullptr) {
    profile.set_counts(counts.total());
    *description = profile;
  }
  return is_complete;
}

} // namespace internal
} // namespace Thick_intersection_d

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of a range whose distance is within a bound, each exactly once.

The result is that of real arithmetic on the given coordinates and the given bound, for every
kernel: also for `Simple_cartesian<double>`, and also for pairs that are exactly at the bound. Which
arithmetic is used is chosen by the `Scene_profile`. Equal points at different positions are a pair;
a point is never paired with itself. A bound of zero finds the duplicates.

It takes \f$ O(n \log n + k) \f$ time and \f$ O(n) \f$ space in fixed dimension, \f$ k \f$ being the
number of pairs \cgalCite{v-riato-03}. The algebraic degree is 2.

\tparam ConcurrencyTag is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. In
sequence, the order of reports depends on the input alone. In parallel the same pairs are reported
in any order, and the callback is called by several threads at once, and must allow that;
`Parallel_tag` requires \tbb.

\tparam PointRange is a range of `Point_2`, `Point_3` or `Point_d` of a kernel of \cgal, with
forward iterators or better. It is neither copied nor reordered.

\tparam NT is a number type as described for `Distance_bound`. It need not be that of the kernel.

\tparam Callback is callable with `(std::size_t i, std::size_t j)`. It returns `void`, or `bool` to
stop the search by returning `false`.

\param points the points, all of the same dimension.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param callback is called for each pair, with the positions \f$ i < j \f$ of the two points in the
range.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the range}
    \cgalParamDefault{the elements are the points}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of the kernel of the points}
    \cgalParamDefault{the kernel deduced from the point type}
    \cgalParamExtra{Accepted as by other functions of \cgal; the points alone tell their kernel.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor `bool(double)` that is called with the progress between 0 and 1,
                          and cancels the search by returning `false`}
    \cgalParamDefault{none}
    \cgalParamExtra{In parallel it is called by one thread at a time, not always the same.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument if a coordinate is NaN or infinite, if the points differ in dimension,
or if the bound is negative or NaN, before anything is reported. The message tells the position of
the point. Exceptions of the callback pass through.
\throws std::runtime_error if the processor is set to flush denormal numbers to zero.

\sa `thick_self_intersection_d()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(const PointRange& points, const Distance_bound<NT>& bound,
                                 Callback&& callback,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements = internal::make_elements(points, np);
  return internal::report_near_pairs<ConcurrencyTag>(elements, std::nullopt, bound, callback, np);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of points of a range whose distance is within a bound as the version above, and
tells about the scene and the search in `profile`.

If a tier is forced in `profile`, by `Scene_profile::force_tier()`, the search uses that one.
Whatever the profile was made for, the points are looked at again, and a tier that is not exact for
them is refused. A `Scene_profile` without points serves if only the answer is wanted.

\param points,bound,callback,np as in the version above.
\param profile is replaced by the profile of the points and the bound, with the same tier forced,
and with the numbers of pairs that each kind of arithmetic has decided. It is left alone if the
function throws.

\throws std::invalid_argument as the version above, and if the forced tier is not exact for the
scene.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT, class Callback,
          class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(const PointRange& points, const Distance_bound<NT>& bound,
                                 Callback&& callback, Scene_profile& profile,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements = internal::make_elements(points, np);
  return internal::report_near_pairs<ConcurrencyTag>(elements, std::nullopt, bound, callback, np,
                                                     &profile);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one range and a point of another whose distance is within a bound,
each exactly once.

Pairs within a range are not reported, and not tested. Otherwise as the version for one range, where
\f$ n \f$ is the number of points of both ranges and \f$ k \f$ the number of close pairs of their
union.

\param points_a, points_b the points, of the same type and dimension in both ranges.
\param bound made by `within_distance()` or `within_squared_distance()`.
\param callback is called for each pair with the position \f$ i \f$ of its point in `points_a` and
the position \f$ j \f$ of its point in `points_b`.
\param np as for the version for one range; the property map is applied to both ranges.

\return `false` iff the callback or the progress functor stopped the search.

\throws std::invalid_argument as the version for one range; positions in the message go on from the
first range to the second.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(const PointRangeA& points_a, const PointRangeB& points_b,
                                 const Distance_bound<NT>& bound, Callback&& callback,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements_a = internal::make_elements(points_a, np);
  const auto elements_b = internal::make_elements(points_b, np);
  const internal::Joined_elements elements(elements_a, elements_b);
  return internal::report_near_pairs<ConcurrencyTag>(elements, elements_a.size(), bound, callback,
                                                     np);
}

/*!
\ingroup PkgThickIntersectionDRef

reports all pairs of a point of one range and a point of another whose distance is within a bound as
the version above, with a profile of the points of both ranges, which is as in the version for one
range.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRangeA, class PointRangeB, class NT,
          class Callback, class NamedParameters = parameters::Default_named_parameters>
bool fixed_radius_near_neighbors(const PointRangeA& points_a, const PointRangeB& points_b,
                                 const Distance_bound<NT>& bound, Callback&& callback,
                                 Scene_profile& profile,
                                 const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements_a = internal::make_elements(points_a, np);
  const auto elements_b = internal::make_elements(points_b, np);
  const internal::Joined_elements elements(elements_a, elements_b);
  return internal::report_near_pairs<ConcurrencyTag>(elements, elements_a.size(), bound, callback,
                                                     np, &profile);
}

/*!
\ingroup PkgThickIntersectionDRef

returns for each point of a range all other points whose distance is within a bound.

It takes \f$ O(n \log n + k \log k) \f$ time and \f$ O(n + k) \f$ space in fixed dimension,
\f$ k \f$ being the number of pairs \cgalCite{v-riato-03}. The result does not depend on the number
of threads.

The parameters are those of `fixed_radius_near_neighbors()`.

\return the lists. If the progress functor cancels, those of the pairs found until then.

\throws std::invalid_argument as `fixed_radius_near_neighbors()`.
\throws std::length_error if there are \f$ 2^{32} \f$ points or more.
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange, class NT,
          class NamedParameters = parameters::Default_named_parameters>
Neighbor_lists fixed_radius_neighbor_lists(const PointRange& points,
                                           const Distance_bound<NT>& bound,
                                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Thick_intersection_d::internal;
  const auto elements = internal::make_elements(points, np);
  if(elements.size() > (std::numeric_limits<Neighbor_lists::Position>::max)())
    throw std::length_error("There are more points than a list of neighbors can tell apart.");
  internal::Neighbor_collector<ConcurrencyTag> collector(elements.size());
  internal::report_near_pairs<ConcurrencyTag>(elements, std::nullopt, bound, collector, np);
  return collector.lists();
}

} // namespace CGAL

#endif // CGAL_FIXED_RADIUS_NEAR_NEIGHBORS_H
