// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of near objects: ours, and what else there is. Each other library is compiled in a
// file of its own. All of them list the pairs, and decide by the doubles of the scene.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_NEAR_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_NEAR_METHODS_H

#include "Method.h"

#include "measuring/Tally.h"
#include "scenes/Object_scene.h"

namespace thick_benchmark {

using Near_method = Method<Pair_list, Near_scene>;

Near_method near_objects(); // fixed_radius_near_neighbors

// thick_self_intersection_d of segments, or of triangles in space, each with half of the distance
// as its radius.
Near_method thickened_objects();

// The pairs of boxes that meet, each grown by half of the distance: thick_self_intersection_d.
Near_method grown_boxes();

// CGAL: box_self_intersection_d of grown boxes, and squared_distance().
Near_method near_by_boxes(std::ptrdiff_t cutoff);

// Embree, in space: the collisions of grown boxes of floats, and squared_distance() of CGAL.
Near_method near_by_embree();

// Slowly, in rational numbers, by the oracle of the tests.
Pair_list near_pairs_by_oracle(const Near_scene& scene);

// Segments between random points of the unit cube, and the small triangles at random places in it
// that they meet: by thick_intersection_d, and by an AABB_tree that is asked for each segment.
std::vector<Counted> ways_of_rays(std::size_t ray_count, std::size_t triangle_count);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_NEAR_METHODS_H
