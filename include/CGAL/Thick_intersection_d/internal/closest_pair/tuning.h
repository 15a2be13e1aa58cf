// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TUNING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TUNING_H

// The constants that the search for the closest pair is tuned by. Any values give the same pair.
//
// The factors below are times with another value over times with this one: medians of 7 paired runs
// of 10^6 points (more for fewer points) on an AMD EPYC with AVX-512.

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The pairs of so few points are compared one by one.
inline constexpr std::size_t small_size = 40;

// A sample of the points finds how far the join has to look: each point is drawn with a probability
// of 1/8, by steps of 1 to 15. Uniform points in the plane: 1.29 by steps to 7, 1.19 to 31.
inline constexpr std::size_t max_sample_step = 15;

// A join gives up after so many comparisons of entries per point. Slabs find all near pairs of a
// crowded scene in the time of about as many comparisons. With a share of this for a sample,
// samples of uniform points are crowded: 1.43 times the instructions.
inline constexpr std::size_t max_steps_per_point = 5;

// Of few points, more may be near by chance. 20,000 points of a lattice in space: 1.6 times the
// instructions with 5000 more steps for all samples.
inline constexpr std::size_t max_steps_of_few_points = 5000;

// More pairs per point that are as near as the closest pair of a sample are not to be expected.
inline constexpr std::size_t max_near_pairs_per_point = 100;

// Where a scene extends over more distances than this, slabs search it once, and each pair is
// looked at. 64,000 points in equal steps, and 512 at many scales: 0.58. A lattice has no such
// extent; 216,000 of its points in space take 1.2 times as long if they are searched once.
inline constexpr double max_narrow_reaches = 1 << 21;

// The cells of a join are 2 to 16 distances long. If the points are uniform then one cell in 64 has
// a point in it, so that most points are alone in their cell. At least 1: 1.52 for 5000 points. At
// most 4: 1.30 for uniform points. One cell in 512: 1.17 for uniform points in space.
inline constexpr double min_cell_side = 2;
inline constexpr double max_cell_side = 16;
inline constexpr double cells_per_point = 64;

// Cells of s distances have about 15 s^3 pairs of a cluster in space, for the distance of an eighth
// of it: a third of the steps of a join if the cluster has 16 s^3 points.
inline constexpr double points_of_long_cells = 16;

// Points in one place of a hash table of equal points: expected are 0.25 steps per point or less.
inline constexpr std::size_t max_equality_steps_per_point = 20;

// The entries of a join are distributed over lists of so many, which fit in a cache with their hash
// table. Uniform points in the plane: 1.15 with 1024, 1.09 with 16,384. There are at most 2048
// lists, because each has a page of its own; 10^7 points: 0.87 with 512, 1.01 with 8192.
inline constexpr std::size_t entries_per_list = 4096;
inline constexpr std::size_t max_list_count = 2048;

// In parallel, there are lists for all threads unless these would have fewer entries, and threads
// enter at least so many points at a time, and at most as many as a cache holds the entries of.
inline constexpr std::size_t min_entries_per_list = 512;
inline constexpr std::size_t min_entry_block_size = 512;
inline constexpr std::size_t max_entry_block_size = 32768;

// A block has room for this many times the entries that are expected, and for some more. Those of a
// block with more entries have memory of their own.
inline constexpr double entry_room = 1.0625;
inline constexpr std::size_t min_entry_room = 64;

// In parallel, a sample is drawn from so many points at a time.
inline constexpr std::size_t sample_stratum_size = 8192;

// The first look for a close pair takes this part of the points, the first ones of the range: where
// cells are heavy, these points will do. With a 16th, to find that there is no close pair takes
// 1.44 times as long in the plane, 1.91 times in space.
inline constexpr std::size_t first_look_divisor = 128;

// A cell has 3^5 - 1 neighbors in dimension 5, and 728 in dimension 6.
inline constexpr int max_bucket_dimension = 5;

// A short strip of the divide and conquer is scanned without cells, and again with cells if it has
// more candidates per point than this. 20,000 flat points in dimension 5, the same along the first
// and the last axis: 17 times the time without this limit.
inline constexpr std::size_t max_strip_steps_per_point = 32;

// The divide and conquer compares the points of a leaf directly. 200,000 points: 1.02 with 2 and
// with 8, 1.15 with 16. It gives no smaller range than a task to another thread.
inline constexpr std::size_t max_leaf_size = 3;
inline constexpr std::size_t min_task_size = 2000;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_TUNING_H
