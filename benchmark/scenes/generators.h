// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The scenes that are measured. A scene is the same in each run; its points are in random order.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_GENERATORS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_GENERATORS_H

#include "Scene.h"

#include <cstdint>
#include <functional>

namespace thick_benchmark {

// n points in the unit square or cube of any dimension, with the distance for which k pairs are
// expected.
Scene uniform(int dimension, std::size_t n, double k);

// n points in the unit square or cube, all of them within the distance of each other.
Scene dense(int dimension, std::size_t n);

// n points at one place, and r = 0.
Scene identical(int dimension, std::size_t n);

// The lattice of m points a side, with steps of `unit` from 0, and r = unit: each point has its
// neighbours along the axes exactly at r, or next to it where products with `unit` are rounded.
Scene lattice(int dimension, std::size_t m, double unit);

// 18 of 20 points at one place, the others uniform.
Scene mostly_identical(int dimension, std::size_t n);

// ---- scenes without a distance: r is 0 ----------------------------------------------------------

// Gaussian bells of very different width around uniform centres.
Scene clusters(int dimension, std::size_t n);

// The points of a TSPLIB file on a lattice of integers, repeated side by side up to n of them.
Scene tiled(const std::string& tsplib_file, std::size_t n);

// A path with steps of every length: the length exceeds s with probability s^-1.
Scene levy_flight(int dimension, std::size_t n);

// An oblique plane and an oblique line in space, up to rounding.
Scene oblique_plane(std::size_t n);
Scene oblique_line(std::size_t n);

// ---- their distances ----------------------------------------------------------------------------

// Returns the number of pairs within r, or a larger number than `limit` if there are more.
using Count = std::function<std::uint64_t(const Scene&, std::uint64_t limit)>;

// The same scene with a distance that gives between n and 4 n pairs.
Scene with_fitting_distance(Scene scene, const Count& count);

// The same scene with the smallest integer as distance that gives at least n pairs.
Scene with_fitting_integer_distance(Scene scene, const Count& count);

// The same scene, with its first point moved 10^15 times the distance away.
Scene with_outlier(Scene scene);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_GENERATORS_H
