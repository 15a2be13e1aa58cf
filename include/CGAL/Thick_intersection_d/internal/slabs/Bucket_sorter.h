// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_BUCKET_SORTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_BUCKET_SORTER_H

// Sorts points along an axis. It takes linear time unless points crowd within crowds within crowds,
// and O(n log n) in the worst case.

#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Sorts points that are nearly in order.
template <int axis, class Point>
void insertion_sort(Point* first, Point* last)
{
  // Invariant: the points before p are in order.
  for(Point* p = first; p < last; ++p) {
    if(p == first || !(p->x[axis] < p[-1].x[axis]))
      continue;
    const Point point = *p;
    Point* hole = p;
    for(; hole != first && point.x[axis] < hole[-1].x[axis]; --hole)
      *hole = hole[-1];
    *hole = point;
  }
}

// Sorts up to 16 points by counting for each how many are before it, without branches.
template <int axis, class Point>
void rank_sort(Point* first, Point* last)
{
  Point points[16];
  std::ptrdiff_t rank[16] = {};
  const std::ptrdiff_t size = last - first;
  std::copy(first, last, points);
  for(std::ptrdiff_t i = 1; i < size; ++i)
    for(std::ptrdiff_t j = 0; j < i; ++j) {
      const bool is_behind = !(points[i].x[axis] < points[j].x[axis]);
      rank[i] += is_behind;
      rank[j] += !is_behind;
    }
  for(std::ptrdiff_t i = 0; i < size; ++i)
    first[rank[i]] = points[i];
}

template <int Dimension>
class Bucket_sorter
{
  using Point = Slab_point<Dimension>;

public:
  // Whether so few points need no buckets.
  static bool are_few(std::ptrdiff_t count) { return count <= 16; }

  template <int axis>
  void sort(Point* first, Point* last)
  {
    sort<axis>(first, last, 0);
  }

private:
  static constexpr int greatest_depth = 2;

  // Sorts points into as many buckets as there are points, and those with many points again.
  template <int axis>
  void sort(Point* first, Point* last, int depth)
  {
    if(are_few(last - first)) {
      rank_sort<axis>(first, last);
      return;
    }
    const Place size = static_cast<Place>(last - first);
    Range range;
    for(const Point* p = first; p != last; ++p)
      range.add(p->x[axis]);
    const Equal_cut cut(range, size);
    if(depth == greatest_depth || cut.count() == 1) {
      std::sort(first, last, [](const Point& p, const Point& q) { return p.x[axis] < q.x[axis]; });
      return;
    }
    Place* const ends = ends_[depth].require(cut.count()); // of buckets, when all points are in
    distribute<axis>(first, last, cut, ends);
    for(Place b = 0, begin = 0; b < cut.count(); begin = ends[b++])
      if(!are_few(ends[b] - begin))
        sort<axis>(first + begin, first + ends[b], depth + 1);
    insertion_sort<axis>(first, last);
  }

  template <int axis>
  void distribute(Point* first, Point* last, const Equal_cut& cut, Place* ends)
  {
    std::fill(ends, ends + cut.count(), 0);
    for(const Point* p = first; p != last; ++p)
      ++ends[cut(p->x[axis])];
    Place sum = 0;
    for(Place b = 0; b < cut.count(); ++b)
      sum += std::exchange(ends[b], sum);
    Point* const points = points_.require(sum);
    std::copy(first, last, points);
    for(const Point* p = points; p != points + sum; ++p)
      first[ends[cut(p->x[axis])]++] = *p;
  }

  std::array<Buffer<Place>, greatest_depth> ends_;
  Buffer<Point> points_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_BUCKET_SORTER_H
