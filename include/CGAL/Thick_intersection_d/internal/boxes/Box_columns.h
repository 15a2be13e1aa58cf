// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_COLUMNS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_COLUMNS_H

// The boxes of a piece in the order of their lower ends, as columns.

#include <CGAL/Thick_intersection_d/internal/arrays/Equal_cut.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/radix_sort.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/boxes/Piece_box.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The order of the boxes is that of their buckets along the sweep axis. Boxes in a bucket are in
// any order. The bucket of a coordinate is a monotone function. So a box that begins at x or before
// is before end_of(x), and a box that begins at x or behind is not before begin_of(x). Where boxes
// crowd in buckets, they are sorted, and each is a bucket of its own.
template <int Axes>
class Box_columns
{
public:
  // Counts the boxes of each bucket. Returns the number of pairs in common buckets.
  double count(const Span<Piece_box<Axes>>& boxes, int sweep_axis, const Equal_cut& cut)
  {
    boxes_ = boxes;
    axis_ = sweep_axis;
    cut_ = cut;
    is_sorted_ = false;
    Place* const ends = ends_.require(cut.count());
    std::fill(ends, ends + cut.count(), 0);
    for(const Piece_box<Axes>* box = boxes.first; box != boxes.last; ++box)
      ++ends[cut(box->low[axis_])];
    double pairs = 0;
    Place sum = 0;
    for(Place b = 0; b < cut.count(); ++b) {
      pairs += double(ends[b]) * ends[b];
      sum += std::exchange(ends[b], sum);
    }
    return pairs;
  }

  // Makes the columns, in the order of the buckets. Call it after count().
  void distribute()
  {
    require_columns();
    Place* const ends = ends_.data();
    for(const Piece_box<Axes>* box = boxes_.first; box != boxes_.last; ++box)
      put(*box, ends[cut_(box->low[axis_])]++);
  }

  // Makes the columns, in the order of the lower ends.
  void sort()
  {
    is_sorted_ = true;
    require_columns();
    order_.clear();
    for(Place i = 0; i < size(); ++i)
      order_.push_back({radix_key(boxes_.first[i].low[axis_]), i});
    radix_sort(order_);
    for(Place i = 0; i < size(); ++i)
      put(boxes_.first[order_[i].value], i);
  }

  Place size() const { return boxes_.size(); }
  double low(Place place) const { return columns_.low[0][place]; }

  Place begin_of(double x) const
  {
    if(is_sorted_)
      return static_cast<Place>(std::lower_bound(lows(), lows() + size(), x) - lows());
    const Place bucket = cut_(x);
    return bucket == 0 ? 0 : ends_.data()[bucket - 1];
  }

  Place end_of(double x) const
  {
    if(is_sorted_)
      return static_cast<Place>(std::upper_bound(lows(), lows() + size(), x) - lows());
    return ends_.data()[cut_(x)];
  }

  // Makes the boxes of `others` from place begin(i) on, as far as they may begin within it, the
  // candidates of the box at place i. Returns the number of all candidates.
  template <class Begin>
  std::uint64_t set_candidates(const Box_columns& others, const Begin& begin)
  {
    Place* const begins = candidate_begins_.require(size());
    Place* const ends = candidate_ends_.require(size());
    std::uint64_t count = 0;
    for(Place i = 0; i < size(); ++i) {
      begins[i] = begin(i);
      ends[i] = others.end_of(columns_.high[0][i]);
      count += ends[i] - begins[i];
    }
    columns_.begins = begins;
    columns_.ends = ends;
    return count;
  }

  const Box_run<Axes>& run() const { return columns_; }

private:
  const double* lows() const { return columns_.low[0]; }

  // Makes room for the boxes, and for `lanes` boxes of NaN behind them.
  void require_columns()
  {
    const Place capacity = size() + lanes;
    for(int axis = 0; axis < Axes; ++axis) {
      columns_.low[axis] = lows_[axis].require(capacity);
      columns_.high[axis] = highs_[axis].require(capacity);
      std::fill_n(lows_[axis].data() + size(), lanes, std::numeric_limits<double>::quiet_NaN());
      std::fill_n(highs_[axis].data() + size(), lanes, std::numeric_limits<double>::quiet_NaN());
    }
    columns_.positions = positions_.require(size());
    columns_.sides = sides_.require(size());
    columns_.first = 0;
    columns_.last = size();
    columns_.has_copies = false;
  }

  // The first column is that of the sweep axis, which changes its place with axis 0.
  void put(const Piece_box<Axes>& box, Place place)
  {
    for(int column = 0; column < Axes; ++column) {
      const int axis = column == 0 ? axis_ : column == axis_ ? 0 : column;
      lows_[column].data()[place] = box.low[axis];
      highs_[column].data()[place] = box.high[axis];
    }
    positions_.data()[place] = box.position;
    sides_.data()[place] = box.sides;
    columns_.has_copies |= box.sides != 0;
  }

  Span<Piece_box<Axes>> boxes_ = {nullptr, nullptr};
  int axis_ = 0;
  Equal_cut cut_;
  bool is_sorted_ = false;
  Buffer<Place> ends_; // of the buckets
  std::vector<Keyed_value> order_;
  std::array<Buffer<double>, Axes> lows_;
  std::array<Buffer<double>, Axes> highs_;
  Buffer<Place> positions_;
  Buffer<Place> sides_;
  Buffer<Place> candidate_begins_;
  Buffer<Place> candidate_ends_;
  Box_run<Axes> columns_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_BOX_COLUMNS_H
