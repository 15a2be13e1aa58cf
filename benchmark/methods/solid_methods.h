// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of meshes that intersect: ours, and what else there is. Each makes its own meshes
// ahead, and begins with them.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_SOLID_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_SOLID_METHODS_H

#include "Method.h"

#include "scenes/solid_generators.h"

#include <cstddef>
#include <vector>

namespace thick_benchmark {

using Solid_method = Method<std::size_t, Solid_scene>; // counts the pairs

Solid_method solids_ours(); // thick_feature_self_intersection_d

// The pairs of boxes of faces that meet: thick_self_intersection_d.
Solid_method boxes_of_faces();

// CGAL: Polygon_mesh_processing::intersecting_meshes, with bounded sides.
Solid_method solids_by_pmp();

// FCL: a tree for each mesh, made anew, and a tree of all of them. It tests faces in doubles, and
// does not find what is inside.
Solid_method solids_by_fcl();

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_SOLID_METHODS_H
