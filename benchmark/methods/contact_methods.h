// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether two meshes meet, and all pairs of faces that do; and rays among triangles.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_CONTACT_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_CONTACT_METHODS_H

#include "Counted.h"

#include "scenes/two_meshes.h"

#include <cstddef>
#include <vector>

namespace thick_benchmark {

// Whether the meshes meet, 1 or 0: thick_intersection_d until the first pair, do_intersect() of
// Polygon_mesh_processing, and Rigid_triangle_mesh_collision_detection, which is built and asked
// once, or asked only.
std::vector<Counted> ways_to_any_contact(const Two_meshes& meshes);

// All pairs of faces: thick_intersection_d, and an AABB_tree that is asked for each face.
std::vector<Counted> ways_to_all_contacts(const Two_meshes& meshes);

// Segments between random points of the unit cube, and the small triangles at random places in it
// that they meet: by thick_intersection_d, and by an AABB_tree that is asked for each segment.
std::vector<Counted> ways_of_rays(std::size_t ray_count, std::size_t triangle_count);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_CONTACT_METHODS_H
