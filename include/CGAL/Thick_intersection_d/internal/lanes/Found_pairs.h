// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_FOUND_PAIRS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_FOUND_PAIRS_H

// Pairs that lanes have found, and that sweeps decide and report.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <array>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The point at place i of one run, and the point at place j of the same run or another run.
struct Found_pair
{
  Place i;
  Place j;
};

// Where many boxes meet, most pairs are found in rows: the pairs {i, j}, {i, j + 1} and so on, one
// in each lane. A row is stored as its first pair. This is quicker to write and to read.
struct Found_pairs
{
  static constexpr Place capacity = 1024;
  static constexpr Place row_capacity = capacity / lanes;

  Place count = 0;
  Place row_count = 0;
  std::array<Found_pair, capacity + lanes> pairs; // `lanes` more before a look at count
  std::array<Found_pair, row_capacity> rows;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_LANES_FOUND_PAIRS_H
