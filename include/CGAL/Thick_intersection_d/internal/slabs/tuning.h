// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_TUNING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_TUNING_H

// The constants that the slab route is tuned by. Any values give the same pairs; these give them
// fast.
//
// The factors below are times with another value over times with this one: medians of 9 paired runs
// of 10^6 points (5 or 3 of 10^7) on an AMD EPYC with AVX-512. "Sparse" are uniform points with k =
// n/2, "dense" with k = 10 n; clusters and Levy flights have fewer pairs.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The height of slabs and strips, in reaches. Lower ones have more points in their borders, higher
// ones have more candidates that are far apart along other axes. Dense points in space: 1.38 with
// 1, 1.07 with 3, 1.34 with 4. Sparse points in space: 1.56 with 1, 0.86 with 3, 0.81 with 4.
inline constexpr double usual_height = 2;

// The height, in reaches, from which on points far from each other may crowd in a slab or strip.
// Twice of it costs clusters in space 0.85, but more candidates; 3/4 of it costs them 1.03.
inline constexpr double max_height = 2 * usual_height;

// A scatter into more slabs misses the translation buffer of the processor (TLB). 10^7 sparse
// points in the plane: 1.22 with 256, 1.35 with 4096. With 10^6 points there is no difference.
inline constexpr double max_slab_count = 1024;

// How many candidates per point a strip may have before it counts as crowded. Uniform points have
// less. Very sparse points (k = n/100) in the plane: 1.15 with 4. Levy flights in the plane: 0.88
// with 16, 0.78 with 64; but then every scene may cost so many candidates per point.
inline constexpr double usual_candidates = 8;

// How often a crowded slab, or a crowded bucket, is cut into equal pieces before it is sorted. Two
// levels of buckets resolve clusters in clusters; beyond them digits do.
inline constexpr int max_cut_depth = 2;

// So few points are sorted by rank rather than by buckets. Levy flights in space: 1.10 with 8;
// clusters in space: 1.08 with 60. Elsewhere there is no difference.
inline constexpr int few_points = 16;

// If the whole range of the coordinates is much longer than that of a sample without its tails,
// then the slabs cover the latter with a margin: a single outlier would leave all other points in
// one slab. The numbers are not critical: points outside belong to the first and the last slab,
// which are cut again if they are crowded.
inline constexpr Place sample_size = 512;
inline constexpr Place sample_tail = sample_size / 64; // points left out at either end
inline constexpr double sample_margin = 1. / 16;       // in ranges of the sample
inline constexpr double max_stretch = 4;               // in ranges of the sample

// In parallel, slabs that are too few for the blocks that threads take are cut into columns, so
// that there are about four for each block. The columns must be much wider than the reach, because
// of their borders. In space, few strips of a slab have points of a border.
constexpr double min_slabs_per_block(int dimension) { return dimension == 3 ? 2 : 0.5; }
inline constexpr double slabs_per_block = 4;
inline constexpr double min_column_width = 8; // in reaches

// So many blocks of slabs take the place of a block that threads usually take. They cost hardly any
// work of their own if the thread has taken the one before as well (sweep_blocks.h).
inline constexpr std::size_t slab_blocks_per_block = 4;

// A slab is swept in at most so many blocks: the progress functor is called a thousand times.
inline constexpr double max_block_count = 1024;

// How a search cuts its points. Tests set small numbers, to get many slabs of few points.
struct Slab_tuning
{
  // On average, at least. Larger slabs leave the cache: sparse points in the plane take 1.22 with
  // 8192. Smaller ones gain nothing: 1.01 with 128.
  Place points_per_slab = 1024;

  // Or per slab that a crowded slab is cut into. Clusters in space: 0.94 with 2, 1.03 with 32.
  Place points_per_strip = 8;

  // Where points crowd in the strips as well. Levy flights in space: 1.27 with 4, 0.91 with 40.
  Place points_per_sorted_strip = 12;

  // A strip with more points is low: at most as high as max_height says. Few scenes have high ones
  // with so many points, because crowded strips are cut where the points are.
  Place max_high_strip_size = 64;

  // On average, at least, in each slab that is cut into columns for threads.
  Place points_per_column = 512;

  // A larger slab is cut again, to fit in a cache with its columns. 10^7 sparse points: 1.26 in the
  // plane with 4096, 1.45 in space without a limit.
  Place max_slab_size = 16384;

  // A slab with more candidates is swept in blocks, which threads share. A slab that is not crowded
  // has 8 candidates for each of 16384 points at most, a sixtieth of this number.
  double candidates_per_block = 1 << 23;
};

// Returns how many pieces `size` points in a range are cut into: each of at least the usual height,
// and of `points_per_piece` points or more on average.
inline double piece_count(const Interval& range, Place size, double reach, Place points_per_piece)
{
  return (std::min)(range.half_length() / (usual_height / 2 * reach),
                    static_cast<double>(size / points_per_piece + 1));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_TUNING_H
