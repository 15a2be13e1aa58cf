// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The searches of the faces of a mesh that intersect.

#ifndef THICK_INTERSECTION_BENCHMARK_METHODS_MESH_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_METHODS_MESH_METHODS_H

#include "Method.h"

#include "measuring/Tally.h"
#include "scenes/Mesh_scene.h"

namespace thick_benchmark {

// They share one Surface_mesh.
struct Mesh_searches
{
  Run<Tally> ours;            // thick_mesh_self_intersections
  Run<Tally> as_in_pmp;       // self_intersections of Polygon_mesh_processing
  Run<Tally> boxes_that_meet; // thick_self_intersection_d of the boxes of faces
};

Mesh_searches mesh_searches(const Mesh_scene& scene);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_METHODS_MESH_METHODS_H
