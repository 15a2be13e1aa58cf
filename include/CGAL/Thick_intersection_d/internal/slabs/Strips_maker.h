// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_MAKER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_MAKER_H

// Makes strips of the points of a slab: counts, then sorts.

#include <CGAL/Thick_intersection_d/internal/slabs/Bucket_sorter.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Calls task(first, last) for parts of points that are sorted along an axis: no higher than
// `height`, or of no more than `few` points.
template <int axis, class Point, class Task>
void for_each_sorted_part(Point* first, Point* last, double height, Place few, const Task& task)
{
  while(first != last) {
    const double limit = first->x[axis] + height;
    Point* end = first + 1;
    while(end != last && (end->x[axis] <= limit || end - first < static_cast<std::ptrdiff_t>(few)))
      ++end;
    task(first, end);
    first = end;
  }
}

template <int Dimension>
class Strips_maker
{
  using Point = Slab_point<Dimension>;

public:
  Strips_maker(double reach, const Part_sizes& sizes) : reach_(reach), sizes_(sizes) {}

  // Looks at the points [first, last), of which there are some, and counts them by strips and by
  // buckets along axis 0. In the plane there is one strip.
  void count(const Point* first, const Point* last)
  {
    first_ = first;
    last_ = last;
    box_ = box_of(first, last);
    const double strips = Dimension == 2 ? 1 : part_count(box_[1], size(), reach_, sizes_.strip);
    count_by(Equal_cut(box_[1], strips));
  }

  // Whether so many pairs of points in the same strip may be within a reach along axis 0 that they
  // should not be in one slab if that is high.
  bool is_crowded() const { return !(crowd_ <= usual_crowd * size()); }

  const Range& range(int axis) const { return box_[axis]; }

  // Makes strips of the points that were counted.
  void make(Strips<Dimension>& strips)
  {
    if(Dimension == 3 && is_crowded() && are_strips_high() && size() > sizes_.sorted_part)
      make_sorted_strips(strips);
    else
      make_counted_strips(strips);
    strips.set_crowd(crowd_);
  }

private:
  Place size() const { return static_cast<Place>(last_ - first_); }

  // Whether strips are so high that points far from each other may crowd in them.
  bool are_strips_high() const
  {
    return box_[1].high - box_[1].low > greatest_height * reach_ * across_.count();
  }

  Place bucket(const Point& p) const
  {
    if constexpr(Dimension == 2)
      return along_(p.x[0]);
    else
      return across_(p.x[1]) * along_.count() + along_(p.x[0]);
  }

  void count_by(const Equal_cut& across)
  {
    across_ = across;
    along_ = Equal_cut(box_[0], size() / across.count());
    const Place buckets = across_.count() * along_.count();
    Place* const counts = counts_.require(buckets);
    std::fill(counts, counts + buckets, 0);
    for(const Point* p = first_; p != last_; ++p)
      ++counts[bucket(*p)];

    longest_ = 0;
    double squares = 0;
    for(Place b = 0; b < buckets; ++b) {
      longest_ = (std::max)(longest_, counts[b]);
      squares += static_cast<double>(counts[b]) * counts[b];
    }
    // A point is within reach of those in its own bucket and in so many behind it.
    const double width = (box_[0].high - box_[0].low) / along_.count();
    const double in_reach = squares * (std::ceil(reach_ / width) + 1);
    const double all = static_cast<double>(size()) * size();
    crowd_ = in_reach < all ? in_reach : all; // also if the width is zero
  }

  // Sorts the points into buckets, and those one by one.
  void make_counted_strips(Strips<Dimension>& strips)
  {
    const Place row = along_.count();
    const Place buckets = across_.count() * row;
    Place* const ends = counts_.data(); // of the buckets, when all points are in
    Place sum = 0;
    for(Place b = 0; b < buckets; ++b)
      sum += std::exchange(ends[b], sum);
    Point* const sorted = sorted_.require(size());
    for(const Point* p = first_; p != last_; ++p)
      sorted[ends[bucket(*p)]++] = *p;
    if(!sorter_.are_few(longest_))
      for(Place b = 0, begin = 0; b < buckets; begin = ends[b++])
        if(!sorter_.are_few(ends[b] - begin))
          sorter_.template sort<0>(sorted + begin, sorted + ends[b]);

    strips.reset(size(), across_.count());
    for(Place s = 0, begin = 0; s < across_.count(); ++s) {
      const Place end = ends[(s + 1) * row - 1];
      insertion_sort<0>(sorted + begin, sorted + end);
      strips.append(sorted + begin, sorted + end);
      begin = end;
    }
  }

  // Sorts the points along axis 1, and cuts them into strips where they are.
  void make_sorted_strips(Strips<Dimension>& strips)
  {
    Point* const sorted = sorted_.require(size());
    std::copy(first_, last_, sorted);
    sorter_.template sort<1>(sorted, sorted + size());
    const auto for_each_strip = [&](const auto& task) {
      for_each_sorted_part<1>(sorted, sorted + size(), usual_height * reach_, sizes_.sorted_part,
                              task);
    };
    Place count = 0;
    for_each_strip([&](Point*, Point*) { ++count; });
    strips.reset(size(), count);
    for_each_strip([&](Point* begin, Point* end) {
      sorter_.template sort<0>(begin, end);
      strips.append(begin, end);
    });
  }

  static constexpr double usual_crowd = 8; // pairs per point

  const double reach_;
  const Part_sizes sizes_;
  const Point* first_ = nullptr;
  const Point* last_ = nullptr;
  std::array<Range, Dimension> box_;
  Equal_cut across_{Range(), 1}; // into strips
  Equal_cut along_{Range(), 1};  // strips into buckets
  Place longest_ = 0;            // bucket
  double crowd_ = 0;   // about how many pairs are within reach along axis 0 in the same strip
  Buffer<Place> counts_;
  Buffer<Point> sorted_;
  Bucket_sorter<Dimension> sorter_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_MAKER_H
