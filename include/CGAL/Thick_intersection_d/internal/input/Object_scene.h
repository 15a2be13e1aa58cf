// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_OBJECT_SCENE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_OBJECT_SCENE_H

// What one pass over kernel objects finds: where they are, how large they are, and the grid of
// their coordinates.

#include <CGAL/Thick_intersection_d/internal/input/Interval.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Object_scene
{
  std::size_t size = 0;
  std::vector<Interval> box;   // of all objects; empty if there are none
  std::vector<double> reaches; // along an axis, of points of two objects whose boxes meet
  std::optional<int> grid_exponent; // if all coordinates are doubles
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_OBJECT_SCENE_H
