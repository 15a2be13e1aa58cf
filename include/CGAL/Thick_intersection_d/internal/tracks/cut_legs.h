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
#include <CGAL/Thick_intersection_d/internal/boxes/box_pairs_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A sample of legs, which are spread evenly over the space and time that they are in. All lengths
// are shares of these.
template <class Legs>
class Leg_sample
{
  static constexpr int axes = Legs::dimension + 1;
  using Lengths = std::array<double, axes>;

public:
  Leg_sample(const Legs& legs, double reach) : size_(static_cast<double>(legs.size()))
  {
    constexpr std::size_t least_size = 20, largest_size = 200;
    Random_numbers random;
    std::vector<std::size_t> sample((std::clamp)(legs.size() / 10, least_size, largest_size));
    for(std::size_t& i : sample)
      i = random.below(legs.size());
    for(int axis = 0; axis < axes; ++axis) {
      Interval space;
      for(const std::size_t i : sample)
        space.add(legs.interval(i, axis));
      half_space_[axis] = space.half_length();
      reaches_[axis] = axis < Legs::dimension ? share(reach / 2, axis) : 0;
    }
    for(const std::size_t i : sample)
      legs_.push_back(shares_of(legs, i));
  }

  // Returns the width of stretches with which the search is expected to cost least. Of those that
  // cost the same, as the sample has no longer legs, it is the least one: it cuts a few legs that
  // are much longer than all others.
  double best_width() const
  {
    double best = 1, least = cost(1);
    for(double width = 1. / 2; width >= 1. / 256; width /= 2)
      if(const double sum = cost(width); sum <= least) {
        least = sum;
        best = width;
      }
    return best;
  }

  // Returns how many stretches of a leg are at most so wide, a power of two.
  Place stretch_count(const Legs& legs, std::size_t i, double width) const
  {
    return count_of(shares_of(legs, i), width);
  }

private:
  double share(double half_length, int axis) const
  {
    return half_space_[axis] > 0 ? half_length / half_space_[axis] : 0;
  }

  Lengths shares_of(const Legs& legs, std::size_t i) const
  {
    Lengths shares;
    for(int axis = 0; axis < axes; ++axis)
      shares[axis] = share(legs.interval(i, axis).half_length(), axis);
    return shares;
  }

  static Place count_of(Lengths leg, double width)
  {
    constexpr Place most_stretches = 64;
    std::nth_element(leg.begin(), leg.begin() + 1, leg.end(), std::greater<double>());
    Place count = 1;
    while(count < most_stretches && leg[1] > width * count)
      count *= 2;
    return count;
  }

  // Returns what a search costs for each leg, in pairs of boxes that meet, or infinity if it takes
  // too much memory. A stretch costs as much as two of them. Two boxes with the shares s and t of
  // the space along an axis meet along it with about the probability s + t - s t.
  double cost(double width) const
  {
    constexpr double most_per_leg = 16;
    std::vector<std::pair<Lengths, double>> boxes; // with the numbers of stretches
    double stretches = 0, pairs = 0;
    for(Lengths leg : legs_) {
      const Place count = count_of(leg, width);
      for(int axis = 0; axis < axes; ++axis)
        leg[axis] = (std::min)(1., leg[axis] / count + reaches_[axis]);
      for(const auto& [other, other_count] : boxes) {
        double share = other_count * count;
        for(int axis = 0; axis < axes; ++axis)
          share *= leg[axis] + other[axis] - leg[axis] * other[axis];
        pairs += share;
      }
      boxes.emplace_back(leg, count);
      stretches += count;
    }
    const auto looked_at = static_cast<double>(legs_.size());
    if(stretches > most_per_leg * looked_at)
      return std::numeric_limits<double>::infinity();
    return 2 * stretches / looked_at + pairs * size_ / (looked_at * looked_at);
  }

  double size_; // of all legs
  std::vector<Lengths> legs_;
  Lengths half_space_; // half of the lengths of space and time, which do not overflow
  Lengths reaches_;
};

// Cuts the legs, for a search with a reach. Those of a second range begin at `second`, which moves
// with them.
template <class Legs>
void cut_legs(Legs& legs, double reach, std::size_t& second)
{
  if(legs.size() == 0)
    return;
  const Leg_sample<Legs> sample(legs, reach);
  const double width = sample.best_width();
  if(width == 1)
    return;
  std::vector<Place> counts;
  for(std::size_t i = 0; i < legs.size(); ++i)
    counts.push_back(sample.stretch_count(legs, i, width));
  const auto sum_until = [&](std::size_t end) {
    return std::accumulate(counts.begin(), counts.begin() + std::ptrdiff_t(end), std::size_t(0));
  };
  const std::size_t size = sum_until(legs.size());
  if(size == legs.size() || !fits_box_route(size))
    return;
  second = sum_until(second);
  legs.cut(counts);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_TRACKS_CUT_LEGS_H
