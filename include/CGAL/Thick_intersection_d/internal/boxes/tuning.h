// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_TUNING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_TUNING_H

// The constants that the box route is tuned by. Any values give the same pairs; these give them
// fast.

#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The model of costs, in nanoseconds.
inline constexpr double move_cost = 15;      // of a box that moves to a piece
inline constexpr double box_cost = 25;       // of a box that is swept
inline constexpr double candidate_cost = 1.2; // of a candidate
inline constexpr double piece_cost = 300;    // of a piece

// A cut has to save so much of the time.
inline constexpr double max_cost_after_cut = .8;

// Per box, in one cut.
inline constexpr double max_copies = .5;

inline constexpr double min_boxes_per_piece = 16;

// So few boxes are swept at once.
inline constexpr Place few_boxes = 48;

// How many boxes a plan looks at.
inline constexpr std::size_t box_sample = 1024;
inline constexpr std::size_t first_box_sample = 16384;

// The range of a sample is cut without a tail at either end, if it is so many times shorter.
inline constexpr double sample_tail_share = 1. / 64;
inline constexpr Place max_trim = 4;

// How often pieces are cut again.
inline constexpr int max_box_cuts = 8;

// Pieces with more candidates per box are looked at again.
inline constexpr double usual_box_candidates = 24;

// The boxes of a bucket are candidates of each other. If there are more pairs in buckets than this,
// per box, then sorting pays.
inline constexpr double max_bucket_pairs = 16;

// The length of a long box, in that of all boxes.
inline constexpr double long_share = 1. / 8;

inline constexpr double crowded_share = 1. / 8;
inline constexpr double crowded_candidates = 32;
inline constexpr Place crowd_sample = 512;

// A sweep with more candidates is swept in blocks, which threads share.
inline constexpr double box_candidates_per_block = 1 << 24;

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_TUNING_H
