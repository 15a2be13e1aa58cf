// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_NEAR_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_NEAR_PAIRS_SEARCH_H

// The search behind fixed_radius_near_neighbors(): of points, or of objects.

#include <CGAL/Distance_bound.h>
#include <CGAL/Scene_profile.h>

#include <CGAL/Thick_intersection_d/internal/input/check_range.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_points_search.h>
#include <CGAL/Thick_intersection_d/internal/objects/near_objects_search.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag, class Elements, class Sets, class NT, class Callback,
          class NamedParameters>
bool report_near_pairs(const Elements& points, const Sets& sets,
                       const Distance_bound<NT>& bound, Callback& callback,
                       const NamedParameters& np)
{
  using Point = typename Elements::value_type;
  if constexpr(!Is_point<Point>::value || has_traits_v<Point, NamedParameters>)
    return report_near_objects<ConcurrencyTag>(points, sets, bound, callback, np);
  else
    return report_pairs_of_points<ConcurrencyTag>(points, sets, bound, callback, np);
}

// Takes the tier that is forced in `profile`, and sets `profile` to the profile of the scene.
template <class ConcurrencyTag, class Elements, class Sets, class NT, class Callback,
          class NamedParameters>
bool report_near_pairs(const Elements& points, const Sets& sets,
                       const Distance_bound<NT>& bound, Callback& callback,
                       Scene_profile& profile, const NamedParameters& np)
{
  using Point = typename Elements::value_type;
  if constexpr(!Is_point<Point>::value || has_traits_v<Point, NamedParameters>)
    return report_near_objects<ConcurrencyTag>(points, sets, bound, callback, profile, np);
  else {
    Near_pairs_search<ConcurrencyTag, Elements> search(points, bound, true);
    return search.report_profiled(sets, callback, np, &profile);
  }
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_NEAR_PAIRS_SEARCH_H
