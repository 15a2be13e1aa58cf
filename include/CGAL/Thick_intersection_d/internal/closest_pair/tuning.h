// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TUNING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TUNING_H

// The constants that the search for the closest pair is tuned by. Any values give the same pair.

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The closest pair of so few points is not worth a join.
constexpr std::size_t small_size = 1000;

// A sample of the points tells the join how far to look: each point is drawn with a probability of
// 1/8, by steps of 1 to 15.
constexpr std::size_t max_sample_step = 15;

// A join visits at most so many pairs per point. Cells of twice the distance with points that far
// apart in them, a lattice in space, give about 50 each; clusters give more, and are left to
// others.
constexpr std::size_t max_visits_per_point = 100;

// The cells of a join are 2 to 16 distances long. If the points are uniform then one cell in 64 has
// a point in it, so that most points are alone in their cell.
constexpr double min_cell_side = 2;
constexpr double max_cell_side = 16;
constexpr double cells_per_point = 64;

// The entries of a join are distributed over lists of so many, which fit in a cache with their hash
// table; into at most 2^11 lists, because of the translation buffer of the processor (TLB).
constexpr std::size_t entries_per_list = 4096;
constexpr int max_list_bits = 11;

// In parallel, this many blocks of points are entered into lists of their own.
constexpr std::size_t max_entry_block_count = 16;

// The first look for a close pair is at one point in so many: where cells are heavy, that will do.
constexpr std::size_t first_look_step = 128;

// A cell has 3^5 - 1 neighbors in dimension 5; beyond it the divide and conquer is faster.
constexpr int max_bucket_dimension = 5;

// The divide and conquer compares the points of a leaf directly, and gives no smaller range to
// another thread than a task.
constexpr std::size_t max_leaf_size = 3;
constexpr std::size_t min_task_size = 2000;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TUNING_H
