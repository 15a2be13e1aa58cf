// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of objects, and of points and boxes in four dimensions and more. Each library is
// compiled in a file of its own.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_OBJECT_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_OBJECT_METHODS_H

#include "ours.h"

#include "scenes/Object_scene.h"

#include <vector>

namespace thick_benchmark {

using Object_method = Method<Tally, Object_scene>;

// Whether the compiler knows the dimension of points or boxes, or only they do.
enum class Dimension_kind { STATIC, DYNAMIC };

Search search_objects(const Object_scene& scene); // thick_self_intersection_d, thick_intersection_d
Search search_points_d(const Scene& scene, Dimension_kind kind); // fixed_radius_near_neighbors

// The pairs of segments, triangles or tetrahedra in one set.
Run<Pair_list> list_pairs(const Object_scene& scene);

// The same search with the kernel of plain doubles. It finds wrong pairs, and misses others.
Run<Tally> search_in_doubles(const Object_scene& scene);
Run<Pair_list> list_pairs_in_doubles(const Object_scene& scene);

// thick_box_self_intersection_d, on boxes that lie in the scene, which must outlive the runs.
Search search_boxes_d(const Object_scene& scene, Dimension_kind kind);

// CGAL's box_self_intersection_d and box_intersection_d, and then the exact test: none of boxes,
// and the test of distances of points. Its boxes always have a dimension that the compiler knows.
Object_method boxes_of_objects(std::ptrdiff_t cutoff);
Object_method boxes_d(std::ptrdiff_t cutoff);
Method<Tally> boxes_of_points_d(std::ptrdiff_t cutoff, Dimension_kind kind);

// The searches of the faces of a mesh that intersect. They share one Surface_mesh.
struct Mesh_searches
{
  Run<Tally> ours;            // thick_mesh_self_intersections
  Run<Tally> as_in_pmp;       // self_intersections of Polygon_mesh_processing
  Run<Tally> boxes_that_meet; // thick_self_intersection_d of the boxes of faces
};

Mesh_searches mesh_searches(const Mesh_scene& scene);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_OBJECT_METHODS_H
