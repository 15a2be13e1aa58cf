// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The scenes of objects that are measured. A scene is the same in each run; its objects are in
// random order, around uniform centers in the unit square or cube unless something else is said.
// Where k is given, sizes are such that about k pairs of boxes (of balls: k pairs) are expected.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_OBJECT_GENERATORS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_OBJECT_GENERATORS_H

#include "Object_scene.h"

namespace thick_benchmark {

// ---- boxes --------------------------------------------------------------------------------------

// Each side is uniform between 0 and the same length.
Object_scene uniform_boxes(int dimension, std::size_t n, double k);

// The same in any dimension.
Object_scene uniform_boxes_d(int dimension, std::size_t n, double k);

// Cubes: the side exceeds s with probability s^-2, over three decades.
Object_scene power_law_boxes(int dimension, std::size_t n, double k);

// Cubes: the logarithm of the side is uniform over six decades.
Object_scene log_uniform_boxes(int dimension, std::size_t n, double k);

// Rectangles whose sides have a ratio of up to 100, either way.
Object_scene thin_boxes(std::size_t n, double k);

// Beams of length 100 and thickness 1, along all axes.
Object_scene beams(std::size_t n, double k);

// Boxes that are much longer along the first axis than along the others.
Object_scene long_boxes(int dimension, std::size_t n, double k);

// Cubes around the points of bells of very different width.
Object_scene clustered_boxes(int dimension, std::size_t n);

// Uniform boxes, and one that meets all of them.
Object_scene boxes_with_giant(int dimension, std::size_t n, double k);

// Along the first axis all boxes overlap.
Object_scene boxes_on_one_axis(int dimension, std::size_t n, double k);

// Beams through the whole scene along all axes: most pairs overlap in all axes but one, so that a
// cut along any axis meets many beams, and k ~ n/2. In the plane, beams of the two directions lie
// side by side.
Object_scene trap(int dimension, std::size_t n);

// Each box within the next; and n times the same box.
Object_scene nested_boxes(int dimension, std::size_t n);
Object_scene identical_boxes(int dimension, std::size_t n);

// The boxes of the triangles of a mesh: of a lattice with jitter in the plane, of a wavy torus with
// jitter in space.
Object_scene mesh_boxes(int dimension, std::size_t n);

// ---- balls, segments, triangles -----------------------------------------------------------------

// Balls of radii between 0.3 and 0.5 times a length.
Object_scene uniform_balls(std::size_t n, double k);

// Balls: the radius exceeds s with probability s^-2, over three decades.
Object_scene power_law_balls(std::size_t n, double k);

// Balls: the logarithm of the radius is uniform over six decades.
Object_scene log_uniform_balls(std::size_t n, double k);

// Uniform balls, and one that meets all of them.
Object_scene balls_with_giant(std::size_t n, double k);

// Each ball within the next; and n times the same ball.
Object_scene nested_balls(std::size_t n);
Object_scene identical_balls(std::size_t n);

// Segments of any direction, of length between 0 and the same length. In space, they do not meet.
Object_scene uniform_segments(int dimension, std::size_t n, double k);

// Long straight roads of sqrt(n) segments each.
Object_scene roads(std::size_t n);

// Paths of ten segments in space. About k pairs of boxes are expected besides those of neighbors.
Object_scene paths(std::size_t n, double k);

// Triangles in space, with corners in a cube.
Object_scene uniform_triangles(std::size_t n, double k);

// ---- lattices -----------------------------------------------------------------------------------

// Cubes or balls around random points of a lattice, eight times as many as objects. Half sides and
// radii are 1, 1.5 and 2 steps, so many objects touch. With integers, they do so exactly. With
// decimals, the step is 0.1, and they do so up to rounding: all numbers are read as doubles, and
// the corners of cubes are computed from these.
Object_scene integer_objects(Shape shape, int dimension, std::size_t n);
Object_scene decimal_objects(Shape shape, int dimension, std::size_t n);

// ---- two sets -----------------------------------------------------------------------------------

// The same objects, of which the first half is one set, and the second half the other.
Object_scene in_two_sets(Object_scene scene);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_OBJECT_GENERATORS_H
