// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_SCAN_LEGS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_SCAN_LEGS_H

// Finds the scene of tracks in one pass over their legs.

#include <CGAL/Thick_intersection_d/internal/arithmetic/Double_grid.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/scan_objects.h>

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
  const auto intervals = [&](std::size_t i) {
    return [&legs, i](int axis) { return legs.interval(i, axis); };
  };
  const auto refine = [&](std::size_t i, Double_grid& grid) {
    const auto leg = legs.leg(i);
    leg.add_to(grid, grid);
    return leg.is_exact();
  };
  Object_scene scene = scan_boxes(legs.size(), Legs::dimension + 1, intervals, refine);
  scene.size = legs.track_count();
  add_bound(scene, bound, reach, Legs::dimension);
  return scene;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_SCAN_LEGS_H
