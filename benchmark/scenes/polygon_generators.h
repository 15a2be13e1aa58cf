// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Scenes of simple polygons, counterclockwise. A scene is the same in each run, and has about n
// vertices.

#ifndef THICK_INTERSECTION_BENCHMARK_SCENES_POLYGON_GENERATORS_H
#define THICK_INTERSECTION_BENCHMARK_SCENES_POLYGON_GENERATORS_H

#include <array>
#include <cstddef>
#include <vector>

namespace thick_benchmark {

using Ring = std::vector<std::array<double, 2>>;
using Rings = std::vector<Ring>;

// The quadrangles of a lattice whose nodes are moved, which share their borders.
Rings parcels(std::size_t n);

// The triangles of the same lattice.
Rings triangles_of_parcels(std::size_t n);

// Parcels whose borders have fifty edges each.
Rings parcels_of_long_borders(std::size_t n);

// Stars of 3 to 32 vertices at random places. Some are large.
Rings stars(std::size_t n);

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_SCENES_POLYGON_GENERATORS_H
