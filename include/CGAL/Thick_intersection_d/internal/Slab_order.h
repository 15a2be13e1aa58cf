// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_ORDER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_ORDER_H

// The order of the slab route: the divide and conquer of [V03] made multiway. The last axis is cut
// into slabs, each slab along the axis before, and so on; the points of a part that is not cut
// further are sorted along axis 0.
//
// Parts are cut by a monotone function of the coordinate, so that they follow each other along
// their axis. Nothing else is asked of the rounding of that function: a sweep relies on the ranges
// of coordinates that parts are found to have, not on those they should have.

#include <CGAL/Thick_intersection_d/internal/Slab_points.h>
#include <CGAL/Thick_intersection_d/internal/parallel.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A slab, or a slab of a slab: the places [begin, end), with coordinates in [low, high] along the
// axis that it is a part of.
struct Part
{
  Place begin;
  Place end;
  double low;
  double high;
  std::vector<Part> children; // along the axis before; none if the part is sorted along axis 0
};

using Parts = std::vector<Part>;

template <class ConcurrencyTag, int Dimension>
class Slab_order
{
public:
  Slab_order(Slab_points<Dimension>& points, double reach)
    : points_(points), reach_(reach), values_(make_uninitialized<double>(points.size())),
      targets_(make_uninitialized<Place>(points.size()))
  {}

  // Orders all points; returns the slabs along the last axis.
  Parts operator()()
  {
    Parts slabs;
    Scratch scratch;
    cut(0, points_.size(), Dimension - 1, 0, scratch, slabs);

    std::vector<Parts> divided(slabs.size());
    for_each_block<ConcurrencyTag>(slabs.size(), [&](std::size_t first, std::size_t last) {
      Scratch own_scratch;
      for(std::size_t s = first; s != last; ++s)
        divide(slabs[s], Dimension - 1, false, own_scratch, divided[s]);
    });
    slabs.clear();
    for(Parts& parts : divided)
      std::move(parts.begin(), parts.end(), std::back_inserter(slabs));
    return slabs;
  }

private:
  // A coordinate and the place that it comes from, counted from the begin of its part.
  struct Key
  {
    double x;
    Place place;
  };

  // What sorting a part takes, kept for the next part.
  struct Scratch
  {
    std::unique_ptr<Key[]> keys;
    Place size = 0;
    std::vector<Place> next;
  };

  // Appends `part`, a part along `axis`, to `parts` when it is divided along the axis before, or
  // sorted along axis 0. Returns how many pairs of points in the same sorted part are within a
  // reach along axis 0; but 0 if no part that they are in is tall.
  //
  // Slabs of sparse points are taller than two reaches. If the points in one turn out to crowd
  // along the other axes, as on a line across the slabs, the slab is cut into flat ones after all:
  // then a sweep meets no more than O(C(n + k)) pairs.
  std::size_t divide(Part& part, int axis, bool is_in_tall, Scratch& scratch, Parts& parts)
  {
    const bool is_tall = part.high - part.low > 2 * reach_;
    std::size_t crowd = 0;
    if(axis == 1) {
      sort(part.begin, part.end, 0, scratch);
      if(is_tall || is_in_tall)
        crowd = count_crowd(part);
    }
    else {
      Parts children;
      cut(part.begin, part.end, axis - 1, 0, scratch, children);
      for(Part& child : children)
        crowd += divide(child, axis - 1, is_tall || is_in_tall, scratch, part.children);
    }
    if(!is_tall || crowd <= greatest_crowd * (part.end - part.begin)) {
      parts.push_back(std::move(part));
      return crowd;
    }

    Parts flat_parts;
    cut_sorted(part.begin, part.end, axis, reach_, scratch, flat_parts);
    crowd = 0;
    for(Part& flat : flat_parts)
      crowd += divide(flat, axis, is_in_tall, scratch, parts);
    return crowd;
  }

  // Counts the pairs of a sorted part that are within a reach along axis 0.
  std::size_t count_crowd(const Part& part) const
  {
    const double* x = points_.columns[0].get();
    std::size_t crowd = 0;
    Place first = part.begin; // the first one within reach of i
    for(Place i = part.begin; i != part.end; ++i) {
      while(x[i] - x[first] > reach_)
        ++first;
      crowd += i - first;
    }
    return crowd;
  }

  struct Range
  {
    double low;
    double high;
  };

  Range range(Place begin, Place end, int axis) const
  {
    const double* column = points_.columns[axis].get();
    Range r = {column[begin], column[begin]};
    for(Place i = begin; i < end; ++i) {
      r.low = (std::min)(r.low, column[i]);
      r.high = (std::max)(r.high, column[i]);
    }
    return r;
  }

  // Appends the parts of [begin, end) along `axis`: of equal height, at least a reach high, and not
  // more of them than pays for sparse points. One that gets far more than its share is cut again,
  // and finally sorted.
  void cut(Place begin, Place end, int axis, int depth, Scratch& scratch, Parts& parts)
  {
    if(begin == end)
      return;
    const Range r = range(begin, end, axis);
    const double extent = r.high - r.low;
    const Place size = end - begin;
    const double count = (std::min)(std::floor(extent / reach_), greatest_part_count(size, axis));
    const double scale = count / extent;
    if(!(count >= 2) || !is_usable(scale)) { // Case 1 of [V03]: an axis that is not cut
      parts.push_back({begin, end, r.low, r.high, {}});
      return;
    }
    if(depth == greatest_depth) {
      cut_sorted(begin, end, axis, extent / count, scratch, parts);
      return;
    }

    const Place last = static_cast<Place>(count) - 1;
    const std::vector<Place> ends = distribute(begin, end, axis, r.low, scale, last);
    const Place share = 8 * (size / (last + 1)) + 64;
    Place part_begin = begin;
    for(const Place part_end : ends) {
      if(part_end - part_begin > share)
        cut(part_begin, part_end, axis, depth + 1, scratch, parts);
      else if(part_begin != part_end) {
        const Range part = range(part_begin, part_end, axis);
        parts.push_back({part_begin, part_end, part.low, part.high, {}});
      }
      part_begin = part_end;
    }
  }

  // An extent that overflows has the scale zero, and one that nearly vanishes has infinity.
  static bool is_usable(double scale) { return scale > 0 && std::isfinite(scale); }

  // The number of parts with which uniform points would have as many neighbours per part as parts.
  static double greatest_part_count(Place size, int axis)
  {
    return 2 * std::pow(static_cast<double>(size), 1. / (axis + 1));
  }

  // Moves each point of [begin, end) to the part that its coordinate tells; returns their ends.
  std::vector<Place> distribute(Place begin, Place end, int axis, double low, double scale,
                                Place last)
  {
    const double* column = points_.columns[axis].get() + begin;
    const Place size = end - begin;
    Place* const targets = &targets_[begin];
    std::vector<Place> next(last + 2, 0);
    for(Place i = 0; i < size; ++i) {
      targets[i] = (std::min)(static_cast<Place>((column[i] - low) * scale), last);
      ++next[targets[i] + 1];
    }
    for(Place part = 0; part <= last; ++part)
      next[part + 1] += next[part];
    for(Place i = 0; i < size; ++i)
      targets[i] = next[targets[i]]++;

    const auto scatter = [&](auto* values, double* copy) { // a double holds a position too
      using Value = std::remove_pointer_t<decltype(values)>;
      std::copy(values, values + size, copy);
      for(Place i = 0; i < size; ++i)
        values[targets[i]] = static_cast<Value>(copy[i]);
    };
    for(auto& each : points_.columns)
      scatter(&each[begin], &values_[begin]);
    scatter(&points_.positions[begin], &values_[begin]);

    next.pop_back();
    for(Place& part_end : next)
      part_end += begin;
    return next;
  }

  // Sorts [begin, end) along `axis`, and appends parts of that height or of a single coordinate.
  void cut_sorted(Place begin, Place end, int axis, double height, Scratch& scratch, Parts& parts)
  {
    sort(begin, end, axis, scratch);
    const double* column = points_.columns[axis].get();
    for(Place part_begin = begin; part_begin != end;) {
      const double limit = column[part_begin] + height;
      Place part_end = part_begin + 1;
      while(part_end != end && column[part_end] <= limit)
        ++part_end;
      parts.push_back({part_begin, part_end, column[part_begin], column[part_end - 1], {}});
      part_begin = part_end;
    }
  }

  // Sorts [begin, end) along `axis`: into as many buckets as points, and those one by one.
  void sort(Place begin, Place end, int axis, Scratch& scratch)
  {
    const Range r = range(begin, end, axis);
    if(r.low == r.high)
      return;
    const Place size = end - begin;
    if(size > scratch.size) {
      scratch.keys = make_uninitialized<Key>(size);
      scratch.size = size;
    }
    Key* const keys = scratch.keys.get();
    fill_buckets(&points_.columns[axis][begin], size, r, keys, scratch.next);
    insertion_sort(keys, size);

    const auto apply_order = [&](auto* values, double* copy) {
      using Value = std::remove_pointer_t<decltype(values)>;
      for(Place i = 0; i < size; ++i)
        copy[i] = values[keys[i].place];
      std::transform(copy, copy + size, values, [](double v) { return static_cast<Value>(v); });
    };
    for(auto& column : points_.columns)
      apply_order(&column[begin], &values_[begin]);
    apply_order(&points_.positions[begin], &values_[begin]);
  }

  static bool less(const Key& a, const Key& b) { return a.x < b.x; }

  // Sets `keys` to those of a column, in order but for the order within short buckets.
  static void fill_buckets(const double* column, Place size, const Range& r, Key* keys,
                           std::vector<Place>& next)
  {
    const double scale = size / (r.high - r.low);
    if(!is_usable(scale)) {
      for(Place i = 0; i < size; ++i)
        keys[i] = {column[i], i};
      std::sort(keys, keys + size, less);
      return;
    }

    const auto bucket = [&](double x) {
      return (std::min)(static_cast<Place>((x - r.low) * scale), size - 1);
    };
    next.assign(size + 1, 0);
    for(Place i = 0; i < size; ++i)
      ++next[bucket(column[i]) + 1];
    Place longest = 0;
    for(Place b = 0; b < size; ++b) {
      longest = (std::max)(longest, next[b + 1]);
      next[b + 1] += next[b];
    }
    for(Place i = 0; i < size; ++i)
      keys[next[bucket(column[i])]++] = {column[i], i};

    if(longest > greatest_short_bucket) // next[b] is the end of bucket b now
      for(Place b = 0, bucket_begin = 0; b < size; bucket_begin = next[b++])
        if(next[b] - bucket_begin > greatest_short_bucket)
          std::sort(keys + bucket_begin, keys + next[b], less);
  }

  // Invariant: the keys before i are in order.
  static void insertion_sort(Key* keys, Place size)
  {
    for(Place i = 1; i < size; ++i) {
      const Key key = keys[i];
      Place hole = i;
      for(; hole > 0 && less(key, keys[hole - 1]); --hole)
        keys[hole] = keys[hole - 1];
      keys[hole] = key;
    }
  }

  static constexpr int greatest_depth = 3;
  static constexpr Place greatest_short_bucket = 16;

  // Neighbours along axis 0 per point that are still no crowd.
  static constexpr std::size_t greatest_crowd = 2;

  Slab_points<Dimension>& points_;
  const double reach_;
  // A copy of the column or of the positions that are being reordered, and where they go to.
  // Threads use the places of the slabs that they work on.
  std::unique_ptr<double[]> values_;
  std::unique_ptr<Place[]> targets_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLAB_ORDER_H
