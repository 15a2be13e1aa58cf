// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_BUCKET_SORTER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_BUCKET_SORTER_H

// Sorts points along an axis by buckets, and by buckets of buckets where the points are not spread
// evenly. It takes linear time for evenly spread points, and O(n log n) time in the worst case.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The axis is no template parameter: functions for all axes take long to compile.

// Sorts points that are nearly in order.
template <class Point>
BOOST_NOINLINE void insertion_sort(Point* first, Point* last, std::size_t axis)
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

// Sorts a few points without branches. The rank of a point is the number of points before it.
template <class Point>
BOOST_NOINLINE void rank_sort(Point* first, Point* last, std::size_t axis)
{
  Point points[few_points];
  typename Point::Number x[few_points];
  std::ptrdiff_t rank[few_points] = {};
  const std::ptrdiff_t size = last - first;
  for(std::ptrdiff_t i = 0; i < size; ++i) {
    points[i] = first[i];
    x[i] = first[i].x[axis];
  }
  for(std::ptrdiff_t i = 1; i < size; ++i)
    for(std::ptrdiff_t j = 0; j < i; ++j) {
      const bool is_behind = !(x[i] < x[j]);
      rank[i] += is_behind;
      rank[j] += !is_behind;
    }
  for(std::ptrdiff_t i = 0; i < size; ++i)
    first[rank[i]] = points[i];
}

template <class Point>
class Bucket_sorter
{
public:
  // Whether `count` points are so few that they need no buckets.
  static bool are_few(std::ptrdiff_t count) { return count <= few_points; }

  void sort(Point* first, Point* last, std::size_t axis) { sort(first, last, axis, 0); }

private:
  // Sorts points into as many buckets as there are points. Sorts buckets with many points again.
  void sort(Point* first, Point* last, std::size_t axis, std::size_t depth)
  {
    if(are_few(last - first)) {
      rank_sort(first, last, axis);
      return;
    }
    Interval interval;
    for(const Point* p = first; p != last; ++p)
      interval.add(p->x[axis]);
    const Equal_cut cut(interval, static_cast<double>(last - first));
    if(depth == max_cut_depth || cut.count() == 1) {
      sort_by_digits(first, last, axis);
      return;
    }
    Place* const ends = ends_[depth].require(cut.count());
    distribute(first, last, axis, cut, ends);
    for(Place b = 0, begin = 0; b < cut.count(); begin = ends[b++])
      if(!are_few(ends[b] - begin))
        sort(first + begin, first + ends[b], axis, depth + 1);
    insertion_sort(first, last, axis);
  }

  // Moves points to their buckets. Sets `ends` to the places where the buckets end.
  void distribute(Point* first, Point* last, std::size_t axis, const Equal_cut& cut, Place* ends)
  {
    std::fill(ends, ends + cut.count(), 0);
    for(const Point* p = first; p != last; ++p)
      ++ends[cut(p->x[axis])];
    const Place size = replace_by_prefix_sums(ends, ends + cut.count());
    Point* const points = points_.require(size);
    std::copy(first, last, points);
    for(const Point* p = points; p != points + size; ++p)
      first[ends[cut(p->x[axis])]++] = *p;
  }

  // Sorts points that are too crowded for buckets: digits show what equal pieces do not.
  BOOST_NOINLINE void sort_by_digits(Point* first, Point* last, std::size_t axis)
  {
    std::vector<Keyed_value> order(static_cast<std::size_t>(last - first));
    for(Place p = 0; p < order.size(); ++p)
      order[p] = {radix_key(first[p].x[axis]), p};
    radix_sort(order);
    Point* const points = points_.require(order.size());
    std::copy(first, last, points);
    for(const Keyed_value& item : order)
      *first++ = points[item.value];
  }

  std::array<Buffer<Place>, max_cut_depth> ends_;
  Buffer<Point> points_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_BUCKET_SORTER_H
