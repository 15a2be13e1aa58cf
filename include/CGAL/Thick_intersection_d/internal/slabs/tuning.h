// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_TUNING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_TUNING_H

// The constants that the slab route is tuned by. Any values give the same pairs; these give them
// fast. Times are those of 10^6 points with 1 and 20 neighbors each, on a processor with AVX-512.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <algorithm>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The height of slabs and strips, in reaches. Lower ones have more points near other slabs: in the
// plane, half of the points of a slab two reaches high are within a reach of the next one. Higher
// ones have more pairs of points that are within a reach along axis 0 and no other axis.
constexpr double usual_height = 2;

// The height, in reaches, from which on points far from each other may crowd in a slab or strip.
constexpr double max_height = 2 * usual_height;

// A scatter into more slabs than these misses the translation buffer of the processor (TLB): 10^7
// points took 1.4 times as long with as many slabs as two reaches ask for.
constexpr double max_slab_count = 1024;

// How often a crowded slab, or a crowded bucket, is cut into equal pieces before it is sorted: two
// levels of buckets resolve clusters of clusters.
constexpr int max_cut_depth = 2;

// How many candidates per point a strip may have before it counts as crowded. Uniform points have
// up to 4, with slabs of the usual height.
constexpr double usual_candidates = 8;

// So few points are sorted by rank rather than by buckets. The ranks of 16 points are found without
// a branch; a bucket sort of so few spends its time on empty buckets.
constexpr int few_points = 16;

// The slabs cover the range of the coordinates that a sample finds, with a margin, if the whole
// range is much longer: a single outlier would leave all others in one slab.
constexpr Place sample_size = 512;
constexpr Place sample_tail = sample_size / 64; // points of the sample left out at either end
constexpr double sample_margin = 1. / 16;       // of the range of the sample
constexpr double max_stretch = 4;               // of the whole range, in ranges of the sample

// How a search cuts its points. Tests set small numbers, to get many slabs of few points.
struct Slab_tuning
{
  // With fewer points, on average, there is more to do per slab than per point.
  Place points_per_slab = 1024;
  Place points_per_strip = 8;          // or per slab that a crowded slab is cut into
  Place points_per_sorted_strip = 12;  // where points crowd in the strips as well
  // A larger slab is cut again, to fit in a cache of 1 MB with its columns.
  Place max_slab_size = 16384;
  // A slab with more candidates is swept in blocks, each of which takes some milliseconds.
  double candidates_per_block = 1 << 24;
};

// At most so many blocks of one slab are swept in turn.
constexpr double max_block_count = 1024;

// Returns how many pieces `size` points in a range of the given length are cut into: each of at
// least the usual height, and of `points_per_piece` points or more on average.
inline double piece_count(double length, Place size, double reach, Place points_per_piece)
{
  return (std::min)(length / (usual_height * reach),
                    static_cast<double>(size / points_per_piece + 1));
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_TUNING_H
