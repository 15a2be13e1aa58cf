// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_BALL_PAIRS_SEARCH_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_BALL_PAIRS_SEARCH_H

// The search of balls behind thick_self_intersection_d() and thick_intersection_d(). It takes balls
// of one radius as points.

#include <CGAL/Distance_bound.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/Ball_centers.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/near_points_search.h>
#include <CGAL/Thick_intersection_d/internal/objects/Object_route.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Do_balls_intersect.h>

#include <type_traits>

namespace CGAL {

template <class Point>
class Thick_ball_traits_d;

namespace Thick_intersection_d {
namespace internal {

template <class Point>
struct Box_filter_of_traits<Thick_ball_traits_d<Point>>
{
  using type = std::conditional_t<is_held_by_double_v<Coordinate_t<Point>>, Ball_box_filter,
                                  void>;
};

// Two balls of one radius intersect if their centers are within twice the radius.
template <class Point>
struct Object_route<Thick_ball_traits_d<Point>>
{
  template <class Balls, class Sets, class Callback, class NamedParameters>
  static bool report(const Balls& balls, const Sets& sets,
                     const Thick_ball_traits_d<Point>& traits, Callback& callback,
                     const NamedParameters& np, const Threads& threads)
  {
    check_objects(balls, traits, threads);
    const auto radius = common_radius(balls);
    if(!radius)
      return report_objects(balls, sets, traits, callback, np, threads);
    using Exact = Exact_number_t<std::decay_t<decltype(*radius)>>;
    const Exact diameter(Exact(2) * to_exact<Exact>(*radius));
    return report_pairs_of_points(Ball_centers<Balls>(balls), sets, within_distance(diameter),
                                  callback, np, threads);
  }
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_OBJECTS_BALL_PAIRS_SEARCH_H
