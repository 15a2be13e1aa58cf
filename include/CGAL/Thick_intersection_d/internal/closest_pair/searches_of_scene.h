// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SEARCHES_OF_SCENE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SEARCHES_OF_SCENE_H

// What the searches for the closest pair and for a close one ask of joins and of the search of near
// points.

#include <CGAL/Arithmetic_tier.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/Squared_bound.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_tier.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>
#include <CGAL/Thick_intersection_d/internal/input/Point_doubles.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/near_points/Element_points.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Is_within_distance.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/near_search.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Returns the predicate for a bound. Integers decide the near ties that they can.
template <class Point, class Exact>
Is_within_distance<Point> is_within_of_scene(const Squared_bound<Exact>& bound, const Scene& scene)
{
  const Arithmetic_tier tier
    = first_exact_tier(bound.reach(), scene.grid_exponent, scene.extended_axis_count());
  return {bound, scene, (std::min)(tier, Arithmetic_tier::INT128)};
}

template <int Dimension>
Join_task<Dimension> join_task_of_scene(const Scene& scene, std::uint64_t seed,
                                        const Threads& threads)
{
  Join_task<Dimension> task = {{}, scene.error, seed, threads};
  std::copy_n(scene.box.begin(), Dimension, task.box.begin());
  return task;
}

// Gives the pairs of points of a scene in the plane or in space that are within a distance to the
// taker. There may be as many near ties as pairs, so coordinates are not rounded to 32 bits.
template <class Elements, class Progress>
void search_near_pairs_of_scene(const Elements& points, const Scene& scene,
                                const Is_within_distance<typename Elements::value_type>& is_within,
                                Result_taker& taker, Progress& progress, const Threads& threads)
{
  using Point = typename Elements::value_type;
  Doubles<Elements> doubles(points);
  if constexpr(!is_held_by_double_v<Coordinate_t<Point>>)
    threads.run_blocks(points.size(), [&](std::size_t i, std::size_t last) {
      for(; i != last; ++i)
        for(int axis = 0; axis < scene.dimension(); ++axis)
          doubles.set(i, axis, coordinate_bounds(points[i], axis).first);
    });
  for_plane_and_space<Point>(scene.dimension(), [&](auto dimension) {
    Element_points<dimension, Elements, Progress> near(points, doubles, is_within, progress);
    Near_task<dimension> task;
    std::copy_n(scene.box.begin(), int(dimension), task.box.begin());
    task.near = is_within.filter_of_doubles();
    task.threads = threads;
    return search_near<dimension, double, may_share_slabs>(near, task, taker);
  }, [] { return false; });
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_SEARCHES_OF_SCENE_H
