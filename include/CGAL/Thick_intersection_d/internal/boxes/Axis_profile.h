// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_AXIS_PROFILE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_AXIS_PROFILE_H

// How boxes lie along an axis, estimated from a sample of them.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Random_numbers.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/boxes/tuning.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The sizes of the pieces that boxes are cut into, as shares.
struct Piece_sizes
{
  double sum;   // over all pieces, in boxes: above one, because some boxes are in several pieces
  double pairs; // of boxes in a common piece, over all pieces, as a share of all pairs of boxes
};

class Axis_profile
{
public:
  // Takes a sample of the boxes. Copies along the axis begin before the range of the lower ends.
  template <class Box>
  void set(const std::vector<const Box*>& sample, int axis)
  {
    size_ = static_cast<double>(sample.size());
    bucket_count_ = 2;
    while(2 * bucket_count_ <= sample.size() && bucket_count_ < max_bucket_count)
      bucket_count_ *= 2;
    range_ = Interval();
    for(const Box* box : sample)
      if((box->sides >> axis & 1) == 0 && std::fabs(box->low[axis]) <= max_cut_end)
        range_.add(box->low[axis]);
    count_ends(sample, axis);
    for(int round = 0; round < max_trims && trim(); ++round)
      count_ends(sample, axis);

    meeting_share_ = 1;
    if(!is_cuttable())
      return;
    double pairs = 0;
    for(const Box* box : sample)
      pairs += boxes_below(box->high[axis]) - boxes_below(box->low[axis]);
    meeting_share_ = (std::min)(1., 2 * pairs / (size_ * size_));
    if(sample.size() >= box_sample)
      see_common_places(sample, axis);
  }

  // The range of the lower ends, without copies, and without a few at both ends if it is much
  // shorter without them.
  const Interval& range() const { return range_; }

  // Whether the range can be cut into pieces.
  bool is_cuttable() const { return std::isfinite(scale_) && scale_ > 0; }

  // Into how many pieces at most.
  Place max_piece_count() const { return bucket_count_; }

  // The share of all pairs of boxes that meet along the axis.
  double meeting_share() const { return meeting_share_; }

  // The sizes of `count` pieces of equal length; count is a power of two. A piece holds the boxes
  // that begin in it, and those that begin before it and do not end before it.
  Piece_sizes piece_sizes(Place count) const
  {
    const Place step = bucket_count_ / count;
    Piece_sizes sizes = {0, 0};
    for(Place piece = 0; piece < count; ++piece) {
      const Place end = piece + 1 == count ? bucket_count_ + 1 : (piece + 1) * step;
      const double boxes = lows_[end] - highs_[piece * step];
      sizes.sum += boxes;
      sizes.pairs += boxes * (boxes - 1); // unbiased, unlike the square
    }
    return {sizes.sum / size_, sizes.pairs / (size_ * (size_ - 1))};
  }

private:
  static constexpr Place max_bucket_count = 1024;
  static constexpr int max_trims = 8;
  static constexpr double max_cut_end = 0x1p1020; // so that lengths are finite

  // Counts the lower and upper ends in buckets of equal length.
  template <class Box>
  void count_ends(const std::vector<const Box*>& sample, int axis)
  {
    scale_ = bucket_count_ / range_.length();
    if(!is_cuttable())
      return;
    lows_.assign(bucket_count_ + 2, 0);
    highs_.assign(bucket_count_ + 2, 0);
    for(const Box* box : sample) {
      ++lows_[static_cast<Place>(bucket(box->low[axis]))];
      ++highs_[static_cast<Place>(bucket(box->high[axis]))];
    }
    replace_by_prefix_sums(lows_.data(), lows_.data() + lows_.size());
    replace_by_prefix_sums(highs_.data(), highs_.data() + highs_.size());
  }

  // Leaves out buckets with hardly any lower ends at both ends of the range, if they are most of
  // it: a single outlier would leave all other boxes in one piece. Returns whether it did.
  bool trim()
  {
    if(!is_cuttable())
      return false;
    const double tail = size_ * sample_tail_share;
    Place first = 0;
    while(lows_[first + 1] <= tail)
      ++first;
    Place last = bucket_count_; // the bucket of the highest lower end, which is alone in it
    while(last > first + 1 && lows_[last] >= size_ - tail)
      --last;
    if((last - first) * max_stretch_of_tails > bucket_count_)
      return false;
    range_ = {range_.low + first / scale_, range_.low + last / scale_};
    return true;
  }

  double bucket(double x) const
  {
    return (std::min)((std::max)((x - range_.low) * scale_, 0.), double(bucket_count_));
  }

  // Short boxes that begin at a few places, as those of a lattice do, meet more often than buckets
  // show. Then takes the share of the pairs that meet in a part of the sample: a random box of each
  // step, because equal steps may be those of the scene.
  template <class Box>
  void see_common_places(const std::vector<const Box*>& sample, int axis)
  {
    Random_numbers random;
    const std::size_t step = sample.size() / common_place_sample;
    part_.clear();
    for(std::size_t i = 0; i + step <= sample.size(); i += step) {
      const Box* const box = sample[i + random() % step];
      part_.push_back({box->low[axis], box->high[axis]});
    }
    std::sort(part_.begin(), part_.end(),
              [](const Interval& a, const Interval& b) { return a.low < b.low; });
    double pairs = 0;
    for(auto a = part_.begin(); a != part_.end(); ++a)
      pairs += static_cast<double>(
        std::upper_bound(a + 1, part_.end(), a->high,
                         [](double x, const Interval& b) { return x < b.low; }) - a - 1);
    const double size = static_cast<double>(part_.size());
    const double share = 2 * pairs / (size * (size - 1));
    if(share > 2 * meeting_share_)
      meeting_share_ = share;
  }

  // The number of boxes of the sample that begin before x. Within a bucket they are taken to be
  // evenly spread.
  double boxes_below(double x) const
  {
    const double place = bucket(x);
    const Place b = static_cast<Place>(place);
    return lows_[b] + (place - b) * (lows_[b + 1] - lows_[b]);
  }

  Interval range_;
  double size_ = 0;
  double scale_ = 0;
  double meeting_share_ = 1;
  Place bucket_count_ = 0;
  std::vector<Interval> part_; // of the sample, in order of lower ends
  std::vector<double> lows_;  // the number of lower ends before each bucket
  std::vector<double> highs_; // the same for upper ends
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_AXIS_PROFILE_H
