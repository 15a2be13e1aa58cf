// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PLANNER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PLANNER_H

// Decides how the boxes of a piece are searched: cut along which axis, swept along which axis.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Axis_profile.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <int Axes>
struct Box_plan
{
  int sweep_axis;
  double candidates; // of a box in the sweep, on average, as if two sets were one
  double pair_share = 1; // of these candidates, if there are many of them, and none is cut off
  int cut_axis = -1; // before the sweep, unless it is -1
  Interval range = {0, 0};
  Place piece_count = 1;
  std::array<double, Axes> long_lengths = {}; // longer boxes meet a good part along the axis
};

// Plans by a model of costs. No box is small or large by itself: what counts is in how many pieces
// it would be, and how many candidates the pieces would have.
template <int Axes>
class Box_planner
{
public:
  explicit Box_planner(const Box_tuning& tuning = Box_tuning()) : tuning_(tuning) {}

  Box_plan<Axes> plan(const Piece<Piece_box<Axes>>& piece, std::size_t sample_limit)
  {
    take_sample(piece, sample_limit);
    for(int axis = 0; axis < Axes; ++axis)
      profiles_[axis].set(sample_, axis);
    const double size = piece.size();
    const int sweep_axis = most_selective_axis();
    Box_plan<Axes> plan = {sweep_axis, size / 2 * profiles_[sweep_axis].meeting_share()};
    for(int axis = 0; axis < Axes; ++axis)
      plan.long_lengths[axis] = profiles_[axis].range().length() * long_share;
    double least = max_cost_after_cut * cost(size, plan.candidates, 1);
    for(int axis = 0; axis < Axes; ++axis)
      if(axis != sweep_axis && profiles_[axis].is_cuttable())
        consider_cuts(axis, size, least, plan);
    if(plan.cut_axis < 0 && plan.candidates > tuning_.crowded_candidates)
      plan.pair_share = share_of_pairs(piece.set_count(), sweep_axis);
    return plan;
  }

private:
  // Takes a random box of each step, because boxes at equal steps may be of one kind.
  void take_sample(const Piece<Piece_box<Axes>>& piece, std::size_t sample_limit)
  {
    sample_.clear();
    Random_numbers random;
    const std::size_t step = (std::max)(std::size_t(1), piece.size() / sample_limit);
    for(const auto& span : piece) {
      last_begin_ = sample_.size();
      for(std::size_t i = 0; i < span.size(); i += step)
        sample_.push_back(span.first + i + random.below((std::min)(step, span.size() - i)));
    }
  }

  // The share of pairs among random pairs of the sample that meet along the axis of the sweep. If
  // there are few of these, the answer is one.
  double share_of_pairs(std::size_t set_count, int sweep_axis) const
  {
    Random_numbers random;
    int candidates = 0;
    int pairs = 0;
    const std::size_t first_count = set_count == 1 ? sample_.size() : last_begin_;
    const std::size_t last_count = sample_.size() - last_begin_;
    for(int i = 0; i < crowd_pairs; ++i) {
      const auto& a = *sample_[random.below(first_count)];
      const auto& b = *sample_[last_begin_ + random.below(last_count)];
      if(&a == &b || !do_meet(a, b, sweep_axis))
        continue;
      bool meet = true;
      for(int axis = 0; axis < Axes; ++axis)
        meet = meet && do_meet(a, b, axis);
      ++candidates;
      pairs += meet;
    }
    return candidates < min_crowd_candidates ? 1 : double(pairs) / candidates;
  }

  static bool do_meet(const Piece_box<Axes>& a, const Piece_box<Axes>& b, int axis)
  {
    return a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
  }

  int most_selective_axis() const
  {
    int best = 0;
    for(int axis = 1; axis < Axes; ++axis)
      if(profiles_[axis].meeting_share() < profiles_[best].meeting_share())
        best = axis;
    return best;
  }

  // Time in nanoseconds.
  double cost(double boxes, double candidates, double pieces) const
  {
    return boxes * (tuning_.box_cost + tuning_.candidate_cost * candidates)
           + tuning_.piece_cost * pieces;
  }

  // Considers cuts along `axis` into more and more pieces, until there are too many copies.
  void consider_cuts(int axis, double size, double& least, Box_plan<Axes>& plan) const
  {
    const double candidates = size / 2 * profiles_[plan.sweep_axis].meeting_share();
    const double max_count = (std::min)(double(profiles_[axis].max_piece_count()),
                                        size / tuning_.min_boxes_per_piece);
    for(Place count = 2; count <= max_count; count *= 2) {
      const Piece_sizes sizes = profiles_[axis].piece_sizes(count);
      if(sizes.sum > 1 + max_copies)
        return;
      const double boxes = size * sizes.sum;
      const double candidates_left = candidates * sizes.pairs / sizes.sum;
      const double time = tuning_.move_cost * boxes + cost(boxes, candidates_left, count);
      if(time < least) {
        least = time;
        plan.cut_axis = axis;
        plan.range = profiles_[axis].range();
        plan.piece_count = count;
        plan.candidates = candidates_left;
      }
    }
  }

  const Box_tuning tuning_;
  std::vector<const Piece_box<Axes>*> sample_;
  std::size_t last_begin_ = 0; // where the boxes of the last set begin in the sample
  std::array<Axis_profile, Axes> profiles_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_PLANNER_H
