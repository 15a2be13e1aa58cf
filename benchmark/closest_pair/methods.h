// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The rivals: the closest pair by way of a Delaunay triangulation or of nearest neighbours. They
// compute with the kernel of doubles, and return the squared distance as a double.

#ifndef THICK_INTERSECTION_BENCHMARK_CLOSEST_PAIR_METHODS_H
#define THICK_INTERSECTION_BENCHMARK_CLOSEST_PAIR_METHODS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace thick_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
template <int Dimension>
using Point = std::conditional_t<Dimension == 2, Kernel::Point_2, Kernel::Point_3>;
template <int Dimension>
using Points = std::vector<Point<Dimension>>;

// The shortest edge: the closest pair is one, for distinct points.
double closest_by_delaunay(const Points<2>& points);
double closest_by_delaunay(const Points<3>& points);

// The nearest neighbour of each point.
double closest_by_kd_tree(const Points<2>& points);
double closest_by_kd_tree(const Points<3>& points);

#ifdef THICK_BENCHMARK_HAS_NANOFLANN
double closest_by_nanoflann(const Points<2>& points);
double closest_by_nanoflann(const Points<3>& points);
#endif

} // namespace thick_benchmark

#endif // THICK_INTERSECTION_BENCHMARK_CLOSEST_PAIR_METHODS_H
