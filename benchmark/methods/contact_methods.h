// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether two meshes meet, and all pairs of faces that do.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_CONTACT_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_CONTACT_METHODS_H

#include "Method.h"

#include "scenes/two_meshes.h"

#include <cstddef>
#include <string>
#include <vector>

namespace thick_benchmark {

struct Contact_method
{
  std::string name;
  Run<std::size_t> count; // of pairs of faces, or 1 for any
};

// Whether the meshes meet: thick_intersection_d until the first pair, do_intersect() of
// Polygon_mesh_processing, and Rigid_triangle_mesh_collision_detection, which is built and asked
// once, or asked only.
std::vector<Contact_method> ways_to_any_contact(const Two_meshes& meshes);

// All pairs of faces: thick_intersection_d, an AABB_tree that is asked for each face, and
// box_intersection_d. The last two decide by do_intersect().
std::vector<Contact_method> ways_to_all_contacts(const Two_meshes& meshes);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_CONTACT_METHODS_H
