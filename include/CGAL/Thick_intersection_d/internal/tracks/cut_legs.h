// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CUT_LEGS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CUT_LEGS_H

// Cuts long legs into stretches of time where that pays, because the box of a leg in space and time
// is much larger than the leg. If it is long along one axis only, it is not: that of a point that
// stands still is as small as it can be. So the second longest side of the box counts, the width.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Stretches.h>
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A sample of legs. All lengths are shares of the space and time that they are in.
template <class Legs>
class Leg_sample
{
  static constexpr int axes = Legs::dimension + 1;
  using Boxes = std::vector<Interval_box<axes>>;

public:
  Leg_sample(const Legs& legs, double reach)
    : legs_(legs), reach_(reach), sample_((std::clamp<std::size_t>)(legs.size() / 20, 20, 500))
  {
    Random_numbers random;
    for(std::size_t& i : sample_)
      i = random.below(legs.size());
    for(int axis = 0; axis < axes; ++axis) {
      Interval space;
      for(const std::size_t i : sample_)
        space.add(legs.interval(i, axis));
      half_space_[axis] = space.half_length();
    }
    find_meeting_legs();
  }

  // Returns the width of stretches with which the search is expected to cost least. Of those that
  // cost the same, as the sample has no longer legs, it is the least one: it cuts a few legs that
  // are much longer than all others. Narrower stretches never cost less than there are of them.
  double best_width() const
  {
    constexpr double most_per_leg = 16, cost_of_stretch = 2; // a pair of boxes that meet costs 1
    double best = 1, least = std::numeric_limits<double>::infinity();
    for(double width = 1; width >= 1. / 256; width /= 2) {
      double count = 0;
      for(const std::size_t i : sample_)
        count += stretch_count(i, width);
      count /= static_cast<double>(sample_.size());
      if(count > most_per_leg || cost_of_stretch * count > least)
        break;
      if(const double cost = cost_of_stretch * count + meeting_stretches(width); cost <= least) {
        least = cost;
        best = width;
      }
    }
    return best;
  }

  // Returns how many stretches of a leg are at most so wide, a power of two.
  Place stretch_count(std::size_t leg, double width) const
  {
    constexpr Place most_stretches = 64;
    double longest = 0, second = 0; // the longest sides of the box
    for(int axis = 0; axis < axes; ++axis) {
      const double half_length = legs_.interval(leg, axis).half_length();
      const double length = half_space_[axis] > 0 ? half_length / half_space_[axis] : 0;
      second = (std::max)(second, (std::min)(longest, length));
      longest = (std::max)(longest, length);
    }
    Place count = 1;
    while(count < most_stretches && second > width * count)
      count *= 2;
    return count;
  }

private:
  // Looks at pairs of the sample until enough of them have boxes that meet.
  void find_meeting_legs()
  {
    constexpr std::size_t enough = 100;
    Boxes whole;
    for(const std::size_t i : sample_)
      whole.push_back(boxes(i, 1).front());
    for(std::size_t step = 1; step < sample_.size(); ++step)
      for(std::size_t i = step; i < sample_.size() && meeting_legs_.size() < enough; ++i) {
        const std::size_t a = sample_[i - step], b = sample_[i];
        ++looked_at_;
        if(do_boxes_meet(whole[i - step], whole[i]) && legs_.track_of(a) != legs_.track_of(b))
          meeting_legs_.emplace_back(a, b);
      }
  }

  // Returns how many pairs of stretches, for each leg, are expected to have boxes that meet.
  double meeting_stretches(double width) const
  {
    double count = 0;
    for(const auto& [a, b] : meeting_legs_)
      count += meeting_pairs(boxes(a, stretch_count(a, width)), boxes(b, stretch_count(b, width)));
    return count / looked_at_ * static_cast<double>(legs_.size()) / 2;
  }

  // Returns the boxes of the stretches of a leg, in the order of time.
  Boxes boxes(std::size_t leg, Place count) const
  {
    Boxes boxes(count);
    for(Place k = 0; k < count; ++k)
      for(int axis = 0; axis < axes; ++axis) {
        const Interval interval = legs_.interval(leg, axis, k, count);
        boxes[k][axis] = axis < Legs::dimension ? longer(interval, reach_) : interval;
      }
    return boxes;
  }

  // Returns how many boxes of two legs meet.
  static double meeting_pairs(const Boxes& boxes_a, const Boxes& boxes_b)
  {
    constexpr int time = Legs::dimension;
    double count = 0;
    auto first = boxes_b.begin(); // none before it lasts until a box of the first leg
    for(const Interval_box<axes>& a : boxes_a) {
      while(first != boxes_b.end() && (*first)[time].high < a[time].low)
        ++first;
      for(auto b = first; b != boxes_b.end() && (*b)[time].low <= a[time].high; ++b)
        count += do_boxes_meet(a, *b);
    }
    return count;
  }

  const Legs& legs_;
  const double reach_;
  std::vector<std::size_t> sample_;
  std::array<double, axes> half_space_; // half of the lengths, which do not overflow
  std::vector<std::pair<std::size_t, std::size_t>> meeting_legs_; // of different tracks
  double looked_at_ = 0; // pairs of the sample
};

// Cuts the legs, for a search with a reach.
template <class Legs>
void cut_legs(Legs& legs, double reach)
{
  if(legs.size() == 0)
    return;
  const Leg_sample<Legs> sample(legs, reach);
  const double width = sample.best_width();
  if(width == 1)
    return;
  std::vector<Place> counts;
  for(std::size_t i = 0; i < legs.size(); ++i)
    counts.push_back(sample.stretch_count(i, width));
  if(fits_box_route(std::accumulate(counts.begin(), counts.end(), std::size_t(0))))
    legs.cut(counts);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CUT_LEGS_H
