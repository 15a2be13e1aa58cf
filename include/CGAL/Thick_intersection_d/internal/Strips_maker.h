// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_STRIPS_MAKER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_STRIPS_MAKER_H

// Makes strips of the points of a slab: counts, then sorts.

#include <CGAL/Thick_intersection_d/internal/Slab_cut.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Compares points along an axis.
template <int Dimension>
struct Less_along
{
  int axis;
  bool operator()(const Slab_point<Dimension>& p, const Slab_point<Dimension>& q) const
  {
    return p.x[axis] < q.x[axis];
  }
};

// Calls task(first, last) for parts, no higher than `height`, of points that are sorted along
// `axis`.
template <int Dimension, class Task>
void for_each_flat_part(Slab_point<Dimension>* first, Slab_point<Dimension>* last, int axis,
                        double height, const Task& task)
{
  while(first != last) {
    const double limit = first->x[axis] + height;
    Slab_point<Dimension>* end = first + 1;
    while(end != last && end->x[axis] <= limit)
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
  // buckets along axis 0. In the plane there is one strip. In space, if points crowd in high strips
  // then there are lower ones instead.
  void count(const Point* first, const Point* last)
  {
    first_ = first;
    last_ = last;
    box_ = box_of(first, last);
    if constexpr(Dimension == 2)
      count_by(Equal_cut(box_[1], 1));
    else
      for(const Place strip_size : {sizes_.strip, sizes_.crowded}) {
        count_by(Equal_cut(box_[1], part_count(box_[1], size(), reach_, strip_size)));
        if(!is_crowded_ || !is_high(1))
          break;
      }
  }

  // Whether so many pairs of points in the same strip may be within a reach along axis 0 that they
  // should not be in one slab if that is high.
  bool is_crowded() const { return is_crowded_; }

  const Range& range(int axis) const { return box_[axis]; }

  // Makes strips of the points that were counted.
  void make(Strips<Dimension>& strips)
  {
    if(Dimension == 3 && is_crowded_ && is_high(1))
      make_flat_strips(strips);
    else
      make_counted_strips(strips);
  }

private:
  Place size() const { return static_cast<Place>(last_ - first_); }

  // Whether a part along `axis` is so high that points far from each other may crowd in it.
  bool is_high(int axis) const
  {
    const Range& range = box_[axis];
    const double count = axis == 1 ? across_.count() : 1;
    return range.high - range.low > greatest_height * reach_ * count;
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
    is_crowded_ = !(squares * (std::ceil(reach_ / width) + 1) <= usual_crowd * size());
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
    if(longest_ > greatest_short_bucket)
      for(Place b = 0, begin = 0; b < buckets; begin = ends[b++])
        if(ends[b] - begin > greatest_short_bucket)
          std::sort(sorted + begin, sorted + ends[b], Less_along<Dimension>{0});

    strips.reset(size(), across_.count());
    for(Place s = 0, begin = 0; s < across_.count(); ++s) {
      const Place end = ends[(s + 1) * row - 1];
      insertion_sort(sorted + begin, sorted + end);
      strips.append(sorted + begin, sorted + end);
      begin = end;
    }
  }

  void make_flat_strips(Strips<Dimension>& strips)
  {
    Point* const sorted = sorted_.require(size());
    std::copy(first_, last_, sorted);
    std::sort(sorted, sorted + size(), Less_along<Dimension>{1});
    const double height = usual_height * reach_;
    Place count = 0;
    for_each_flat_part(sorted, sorted + size(), 1, height, [&](Point*, Point*) { ++count; });
    strips.reset(size(), count);
    for_each_flat_part(sorted, sorted + size(), 1, height, [&](Point* begin, Point* end) {
      std::sort(begin, end, Less_along<Dimension>{0});
      strips.append(begin, end);
    });
  }

  // Invariant: the points before p are in order.
  static void insertion_sort(Point* first, Point* last)
  {
    for(Point* p = first; p < last; ++p) {
      if(p == first || !(p->x[0] < p[-1].x[0]))
        continue;
      const Point point = *p;
      Point* hole = p;
      for(; hole != first && point.x[0] < hole[-1].x[0]; --hole)
        *hole = hole[-1];
      *hole = point;
    }
  }

  static constexpr Place greatest_short_bucket = 16;
  static constexpr double usual_crowd = 8; // pairs per point

  const double reach_;
  const Part_sizes sizes_;
  const Point* first_ = nullptr;
  const Point* last_ = nullptr;
  std::array<Range, Dimension> box_;
  Equal_cut across_{Range(), 1}; // into strips
  Equal_cut along_{Range(), 1};  // strips into buckets
  Place longest_ = 0;            // bucket
  bool is_crowded_ = false;
  Buffer<Place> counts_;
  Buffer<Point> sorted_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_STRIPS_MAKER_H
