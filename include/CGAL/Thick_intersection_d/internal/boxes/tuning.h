// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_TUNING_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_TUNING_H

// The constants that the box route is tuned by. Any values give the same pairs; these give them
// fast.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A cut has to save so much of the time, because the model of costs errs.
inline constexpr double max_cost_after_cut = .8;

// Per box, in one cut.
inline constexpr double max_copies = .5;

// How often pieces are cut again. Uniform boxes are cut once in the plane and twice in space.
inline constexpr int max_box_cuts = 8;

// How many boxes a plan looks at: of a piece, and of the whole scene. A thousand boxes estimate a
// share of pairs of 1/1000, which is one candidate per box in a piece of 2000, to a few percent.
// All threads wait for the first plan: of 16384 boxes it takes a thirtieth of the time of 300,000
// rectangles.
inline constexpr std::size_t box_sample = 1024;
inline constexpr std::size_t first_box_sample = 4096;

// How many of them, at least, are compared with each other. 100 pairs meet among so many boxes that
// begin at 80 places.
inline constexpr std::size_t common_place_sample = 128;

// The range of a sample is cut without a tail at either end, if it is so many times shorter. A
// single outlier would leave all other boxes in one piece.
inline constexpr double sample_tail_share = 1. / 64;
inline constexpr Place max_stretch_of_tails = 4;

// The length of a long box, in that of the range. Shorter boxes have at most a thousandth of all
// boxes as candidates.
inline constexpr double long_share = 1. / 1024;

// How many candidates show whether boxes are crowded.
inline constexpr Place crowd_sample = 512;

// How many pairs of boxes of a sample show the same, if so many of them are candidates.
inline constexpr int crowd_pairs = 2048;
inline constexpr int min_crowd_candidates = 64;

// The most blocks of a sweep, which a `Place` counts. More would be of no use to threads.
inline constexpr std::uint64_t max_sweep_blocks = 1 << 24;

// How a search treats its boxes. Tests set small numbers, to get many pieces of few boxes.
struct Box_tuning
{
  // The model of costs, in nanoseconds, on an AMD EPYC with AVX-512. 300,000 uniform cuboids take
  // 37 ms with candidates of .6 ns, and 26 ms with these.
  double move_cost = 15;       // of a box that moves to a piece
  double box_cost = 25;        // of a box that is swept
  double candidate_cost = 1.2; // of a candidate
  double piece_cost = 300;     // of a piece

  // Smaller pieces cost more than the model says.
  double min_boxes_per_piece = 16;

  // So few boxes are swept at once.
  Place few_boxes = 48;

  // Pieces with more candidates per box are looked at again.
  double usual_box_candidates = 24;

  // The boxes of a bucket are candidates of each other. If there are more pairs in buckets than
  // this, per box, then sorting pays.
  double max_bucket_pairs = 16;

  // Boxes are crowded if they have more candidates than this, per box, and fewer of the candidates
  // than this share are pairs. Classes take about 200 ns per box, as long as 200 candidates.
  double crowded_candidates = 256;
  double crowded_share = 1. / 8;

  // Crowded boxes of one class go to the tree if they have more candidates than this, per box and
  // factor 2^(d-1) log2 n. The tree takes .5 us per box in the plane.
  double tree_candidates = 16;

  // A sweep of crowded boxes that have groups is given up if it has looked at so many candidates
  // per box, and at so many more for each wanted pair. Then it has taken a part of the time that
  // the tree takes.
  Place unwanted_candidates = 64;
  std::int64_t candidates_per_wanted_pair = 16;

  // A sweep with more candidates is swept in blocks, which threads share.
  std::uint64_t candidates_per_block = 1 << 24;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_TUNING_H
