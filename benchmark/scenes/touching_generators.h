// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of objects that touch, as those of maps, buildings and meshes do. No object is degenerate.
// A scene is the same in each run, it has about n objects, and they are in random order. The faces
// of a mesh are in the order in which a program would make them.
//
// In scenes of decimals, coordinates are multiples of .1, each rounded to a double. Many are on
// lattices whose rows are oblique. So where a vertex would lie on an edge, it lies beside the edge
// or on it, and only exact arithmetic can tell.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_TOUCHING_GENERATORS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_TOUCHING_GENERATORS_H

#include "Object_scene.h"

namespace thick_benchmark {

// ---- segments -----------------------------------------------------------------------------------

// Decimals: streets in two oblique directions. A street has pieces of two blocks, and the streets
// across end at the ends of pieces and in the middle of pieces.
Object_scene streets(std::size_t n);

// Integers: beams from each node of a lattice in space to some of the 26 nodes around it, most of
// them along the axes. Beams meet at their ends, and some in their middle.
Object_scene frame_of_beams(std::size_t n);

// ---- triangles in the plane ---------------------------------------------------------------------

// The triangles of a lattice whose nodes are moved a little.
Object_scene triangulation(std::size_t n);

// Decimals: oblique rows of triangles. Each row has its vertices in the middle of the edges of the
// row before.
Object_scene rows_of_triangles(std::size_t n);

// ---- triangles in space -------------------------------------------------------------------------

// The triangles of the meshes below.
Object_scene terrain(std::size_t n);
Object_scene floor_of_triangles(std::size_t n);

// Bricks that are two triangles each, in an oblique plane; bricks of a row begin in the middle of
// those of the row before. Decimals are nearly in the plane. Floats that are next to decimals are
// in one plane exactly.
Object_scene bricks_of_decimals(std::size_t n);
Object_scene bricks_of_floats(std::size_t n);

// Decimals: ten floors of triangles, and between them oblique walls of two triangles each.
Object_scene walls_on_floors(std::size_t n);

// ---- tetrahedra ---------------------------------------------------------------------------------

// The six tetrahedra of each cube of a lattice whose nodes are moved a little.
Object_scene tetrahedra_of_mesh(std::size_t n);

// Decimals: the same in place, and once more, shifted by half a cube along two axes.
Object_scene shifted_tetrahedra(std::size_t n);

// ---- meshes -------------------------------------------------------------------------------------

// On a sphere, each vertex moved by about an edge, so that some faces are folded onto others.
Mesh_scene sphere_mesh(std::size_t n);

// Random heights above a lattice.
Mesh_scene terrain_mesh(std::size_t n);

// Decimals: a lattice at one height.
Mesh_scene floor_mesh(std::size_t n);

// The same mesh, with its faces in random order.
Mesh_scene with_shuffled_faces(Mesh_scene mesh);

// ---- near objects -------------------------------------------------------------------------------

// Segments or triangles whose corners are on a lattice, at most two steps apart along each axis.
// About half of the places of the lattice are the first corner of an object, and objects within one
// step are near: many are at exactly this distance. Coordinates are multiples of the step, each
// rounded to a double. No object is degenerate.
Near_scene lattice_scene(Shape shape, int dimension, std::size_t n, double step);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_TOUCHING_GENERATORS_H
