// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_NEAR_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_NEAR_PAIRS_SEARCH_H

// The search for near pairs by the kind of elements. That of points is here. Programs that search
// objects include objects/near_objects_search.h, which has the other one.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_points_search.h>

#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class Element, bool IsPoint>
struct Near_pairs_of
{
  static_assert(IsPoint, "For objects that are no points, and for traits of one's own, include "
                         "<CGAL/fixed_radius_near_neighbors.h>.");

  template <class... Arguments>
  static bool report(const Arguments&...)
  {
    return false; // after one error, and not a second one
  }
};

template <class Point>
struct Near_pairs_of<Point, true>
{
  // Reports the near pairs. Returns false iff the search was stopped. Takes the tier that is forced
  // in a profile, and sets it to the profile of the scene, if there is one.
  template <class Elements, class Sets, class NT, class Callback, class NamedParameters,
            class... Profile>
  static bool report(const Elements& points, const Sets& sets, const Distance_bound<NT>& bound,
                     Callback& callback, const NamedParameters& np, const Threads& threads,
                     Profile&... profile)
  {
    if constexpr(sizeof...(Profile) == 0)
      return report_pairs_of_points(points, sets, bound, callback, np, threads);
    else
      return Near_pairs_search<Elements>(points, bound, true, threads)
        .report_profiled(sets, callback, np, &profile...);
  }
};

template <class Elements, class NamedParameters>
using Near_pairs_of_t
  = Near_pairs_of<typename Elements::value_type,
                  Is_point<typename Elements::value_type>::value
                    && !has_traits_v<typename Elements::value_type, NamedParameters>>;

// Returns search(elements, sets, callback) for the near pairs of points or objects, which describes
// itself in a Scene_profile if there is one behind the threads.
template <class NT, class NamedParameters, class... Profile>
auto near_search(const Distance_bound<NT>& bound, const NamedParameters& np,
                 const Threads& threads, Profile&... profile)
{
  return [&](const auto& elements, const auto& sets, auto& callback) {
    using Search = Near_pairs_of_t<std::decay_t<decltype(elements)>, NamedParameters>;
    return Search::report(elements, sets, bound, callback, np, threads, profile...);
  };
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_NEAR_POINTS_NEAR_PAIRS_SEARCH_H
