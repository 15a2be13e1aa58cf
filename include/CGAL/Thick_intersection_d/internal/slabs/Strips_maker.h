// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_MAKER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_MAKER_H

// Makes a slab ready for the sweep: counts its points by strips and buckets, then sorts them.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Bucket_sorter.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Strips.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Divides points that are sorted along an axis into pieces, and calls task(first, last) for each
// piece. A piece is at most `length` long, or has at most `few` points.
template <class Point, class Task>
void for_each_sorted_piece(Point* first, Point* last, std::size_t axis, double length, Place few,
                           const Task& task)
{
  while(first != last) {
    const double limit = first->x[axis] + length;
    Point* end = first + 1;
    while(end != last && (end->x[axis] <= limit || end - first < static_cast<std::ptrdiff_t>(few)))
      ++end;
    task(first, end);
    first = end;
  }
}

template <class Point>
class Strips_maker
{
  static constexpr bool is_in_plane = Point::dimension == 2;

public:
  Strips_maker(double reach, const Point_sets& sets, const Slab_tuning& tuning)
    : reach_(reach), sets_(sets), tuning_(tuning)
  {}

  // Takes the points [first, last), at least one. Counts them by strips, and by buckets along axis
  // 0.
  void count(const Point* first, const Point* last)
  {
    first_ = first;
    last_ = last;
    box_ = box_of(first, last);
    count_buckets();
    estimate_candidates();
  }

  // Whether the strips hold so many candidates that a high slab should be cut again.
  bool is_crowded() const { return !(candidates_ <= usual_candidates * size()); }

  const Interval& interval(int axis) const { return box_[axis]; }

  // Makes strips of the points that were counted.
  void make(Strips<Point>& strips)
  {
    if constexpr(is_in_plane)
      make_counted_strips(strips);
    else {
      if(are_strips_high() && size() > tuning_.points_per_sorted_strip
         && (is_crowded() || longest_strip() > tuning_.max_high_strip_size))
        make_sorted_strips(strips);
      else
        make_counted_strips(strips);
    }
    const bool are_many = candidates_ > tuning_.candidates_per_block;
    strips.set_candidates(are_many ? strips.count_candidates(reach_) : candidates_);
  }

private:
  Place size() const { return static_cast<Place>(last_ - first_); }

  // Whether strips are so high that points in them may be crowded and yet far from each other.
  bool are_strips_high() const
  {
    return box_[1].length() > max_height * reach_ * across_.count();
  }

  // Returns the number of points in the largest strip.
  Place longest_strip() const
  {
    Place longest = 0;
    for(const Place* c = counts_.data(); c != counts_.data() + bucket_count(); c += along_.count())
      longest = (std::max)(longest, std::accumulate(c, c + along_.count(), Place(0)));
    return longest;
  }

  // Calls task(bucket) with the function that finds the bucket of a point.
  template <class Task>
  void with_buckets(const Task& task) const
  {
    if(is_in_plane || across_.count() == 1)
      task([&](const Point& p) { return along_(p.x[0]); });
    else
      task([&](const Point& p) { return across_(p.x[1]) * along_.count() + along_(p.x[0]); });
  }

  Place bucket_count() const { return across_.count() * along_.count(); }

  // Cuts the slab into strips, in the plane into one strip. Cuts each strip into buckets. There are
  // about as many buckets as points.
  void count_buckets()
  {
    across_ = is_in_plane ? Equal_cut()
                          : Equal_cut(box_[1], piece_count(box_[1], size(), reach_,
                                                           tuning_.points_per_strip));
    along_ = Equal_cut(box_[0], size() / across_.count());
    Place* const counts = counts_.require(bucket_count());
    std::fill(counts, counts + bucket_count(), 0);
    with_buckets([&](const auto& bucket) {
      for(const Point* p = first_; p != last_; ++p)
        ++counts[bucket(*p)];
    });
  }

  // The candidates of a point are the points in its own bucket, and in as many buckets of its strip
  // behind it as a reach covers. The estimate takes these buckets to be equally full. It is an
  // upper bound, because the product of two sizes is at most the mean of their squares.
  void estimate_candidates()
  {
    const Place* const counts = counts_.data();
    longest_ = 0;
    double squares = 0;
    for(Place b = 0; b < bucket_count(); ++b) {
      longest_ = (std::max)(longest_, counts[b]);
      squares += static_cast<double>(counts[b]) * counts[b];
    }
    const double half_width = box_[0].half_length() / along_.count();
    const double behind = std::ceil(reach_ / 2 / half_width) + 1; // no number if both are zero
    const double in_reach = squares * (behind < along_.count() ? behind : along_.count());
    const double all = static_cast<double>(size()) * size();
    candidates_ = in_reach < all ? in_reach : all;
  }

  // Sorts the points into buckets, and then the points of each bucket.
  void make_counted_strips(Strips<Point>& strips)
  {
    Place* const ends = counts_.data(); // the ends of the buckets, once these are full
    Point* const sorted = sorted_.require(size());
    replace_by_prefix_sums(ends, ends + bucket_count());
    with_buckets([&](const auto& bucket) {
      for(const Point* p = first_; p != last_; ++p)
        sorted[ends[bucket(*p)]++] = *p;
    });
    if(!sorter_.are_few(longest_))
      for(Place b = 0, begin = 0; b < bucket_count(); begin = ends[b++])
        if(!sorter_.are_few(ends[b] - begin))
          sorter_.sort(sorted + begin, sorted + ends[b], 0);

    strips.reset(size(), across_.count() * sets_.count());
    for(Place s = 0, begin = 0; s < across_.count(); ++s) {
      const Place end = ends[(s + 1) * along_.count() - 1];
      insertion_sort(sorted + begin, sorted + end, 0);
      strips.append(sorted + begin, sorted + end, sets_);
      begin = end;
    }
  }

  // Sorts the points along axis 1, and cuts the strips where the points are.
  void make_sorted_strips(Strips<Point>& strips)
  {
    Point* const sorted = sorted_.require(size());
    std::copy(first_, last_, sorted);
    sorter_.sort(sorted, sorted + size(), 1);
    const auto for_each_strip = [&](const auto& task) {
      for_each_sorted_piece(sorted, sorted + size(), 1, usual_height * reach_,
                            tuning_.points_per_sorted_strip, task);
    };
    Place count = 0;
    for_each_strip([&](Point*, Point*) { ++count; });
    strips.reset(size(), count * sets_.count());
    for_each_strip([&](Point* begin, Point* end) {
      sorter_.sort(begin, end, 0);
      strips.append(begin, end, sets_);
    });
  }

  const double reach_;
  const Point_sets sets_;
  const Slab_tuning tuning_;
  const Point* first_ = nullptr;
  const Point* last_ = nullptr;
  Box_of_intervals<Point::dimension> box_;
  Equal_cut across_;      // cuts the slab into strips
  Equal_cut along_;       // cuts a strip into buckets
  Place longest_ = 0;     // the size of the largest bucket
  double candidates_ = 0; // the estimated number of candidates
  Buffer<Place> counts_;
  Buffer<Point> sorted_;
  Bucket_sorter<Point> sorter_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_MAKER_H
