// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_SCAN_LEGS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_SCAN_LEGS_H

// Finds the scene of tracks in one pass over their legs.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_objects.h>
#include <CGAL/Thick_intersection_d/internal/predicates/Leg.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The axes of the scene are those of space, and time. The bound on the distance is between two
// doubles, and not above the reach.
template <class Legs>
Object_scene scan_legs(const Legs& legs, const std::pair<double, double>& bound, double reach)
{
  constexpr int dimension = Legs::dimension;
  Object_scene scene;
  scene.size = legs.track_count();
  scene.has_distances = true;
  scene.reaches.resize(dimension + 1);
  scene.box.resize(legs.size() == 0 ? 0 : dimension + 1);
  Double_grid grid;
  grid.add(bound.first);
  bool are_doubles = bound.first == bound.second;
  for(std::size_t i = 0; i < legs.size(); ++i) {
    for(int axis = 0; axis <= dimension; ++axis)
      extend_scene(scene, static_cast<std::size_t>(axis), legs.interval(i, axis));
    const Leg<dimension> leg = legs.leg(i);
    are_doubles = are_doubles && leg.is_exact();
    for(std::size_t end = 0; end < 2; ++end) {
      grid.add(leg.times[end]);
      for(const double x : leg.ends[end])
        grid.add(x);
    }
  }
  for(int axis = 0; axis < dimension; ++axis)
    scene.reaches[static_cast<std::size_t>(axis)] += reach;
  if(are_doubles)
    scene.grid_exponent = grid.exponent();
  return scene;
}

// Returns the degree of the question about two legs: 4 if all have the same times.
template <class Legs>
int degree_of_legs(const Legs& legs)
{
  for(std::size_t i = 1; i < legs.size(); ++i)
    if(!legs.have_common_times(0, i))
      return 10;
  return 4;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_SCAN_LEGS_H
