// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Searches for polygons that overlap, each of which begins with the polygons of its library, and
// for objects that do.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_OVERLAP_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_OVERLAP_METHODS_H

#include "measuring/Tally.h"
#include "scenes/Object_scene.h"
#include "scenes/polygon_generators.h"

#include <functional>

namespace thick_benchmark {

using Overlap_search = std::function<Tally()>;

// Ours, of interiors, and of closed polygons.
Overlap_search overlaps_by_interiors(const Rings& rings);
Overlap_search intersections_of_polygons(const Rings& rings);

// box_self_intersection_d, and do_intersect() of Boolean_set_operations_2 for each pair of boxes.
Overlap_search overlaps_by_boolean_sets(const Rings& rings);

// The tree of GEOS, and relate() of a polygon, prepared, and of each one whose box it meets. GEOS
// computes in doubles, and in more digits where these do not tell an orientation.
Overlap_search overlaps_by_geos(const Rings& rings);

// Ours, of the interiors of objects other than segments and triangles in space, and of the objects
// themselves.
Overlap_search overlaps_by_interiors(const Object_scene& scene);
Overlap_search intersections_of_objects(const Object_scene& scene);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_OVERLAP_METHODS_H
