// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_H

// A slab ready to be swept: strips of points, each sorted along axis 0. In the plane a slab is one
// strip, in space it is cut along axis 1.

#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

struct Range
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x)
  {
    low = x < low ? x : low;
    high = high < x ? x : high;
  }
};

// How many sweeps look at together; see Candidates.h.
constexpr Place lanes = 8;

// Points sorted along axis 0, a column per axis. Behind the last one there are `lanes` points with
// the coordinate NaN along axis 0, which are not near anything: they end all loops.
template <int Dimension>
struct Run
{
  std::array<const double*, Dimension> x;
  const Place* positions;
  Place size;

  // Returns one of `count` shares of the run, whose points a sweep starts with: it meets the points
  // behind them as well.
  Run share(Place index, Place count) const
  {
    const std::uint64_t groups = (size + lanes - 1) / lanes;
    const Place begin = static_cast<Place>(groups * index / count * lanes);
    const Place end = static_cast<Place>(groups * (index + 1) / count * lanes);
    Run share = *this;
    for(const double*& column : share.x)
      column += begin;
    share.positions += begin;
    share.size = (std::min)(end, size) - begin;
    return share;
  }
};

// The places [begin, end) of columns, and the ranges of their coordinates along axis 1 and up.
template <int Dimension>
struct Strip
{
  Place begin;
  Place end;
  std::array<Range, Dimension> ranges;
};

template <int Dimension>
class Strips
{
public:
  using Point = Slab_point<Dimension>;

  const std::vector<Strip<Dimension>>& strips() const { return strips_; }
  Place size() const { return size_; }
  const Range& range(int axis) const { return ranges_[axis]; }

  // About how many pairs of these points a sweep looks at. Not known for parts.
  double crowd() const { return crowd_; }
  void set_crowd(double crowd) { crowd_ = crowd; }

  Run<Dimension> run(const Strip<Dimension>& strip) const
  {
    Run<Dimension> run;
    for(int axis = 0; axis < Dimension; ++axis)
      run.x[axis] = columns_[axis].data() + strip.begin;
    run.positions = positions_.data() + strip.begin;
    run.size = strip.end - strip.begin;
    return run;
  }

  // Makes room for `size` points in `count` strips, and forgets all strips.
  void reset(Place size, Place count)
  {
    const std::size_t places = size + static_cast<std::size_t>(count) * lanes;
    for(auto& column : columns_)
      column.require(places);
    positions_.require(places);
    strips_.clear();
    size_ = 0;
    end_ = 0;
    ranges_ = {};
  }

  // Appends a strip of points that are sorted along axis 0.
  template <class Iterator>
  void append(Iterator first, Iterator last)
  {
    Strip<Dimension> strip{end_, end_, {}};
    for(; first != last; ++first) {
      const Point& p = *first;
      for(int axis = 0; axis < Dimension; ++axis) {
        columns_[axis].data()[strip.end] = p.x[axis];
        strip.ranges[axis].add(p.x[axis]);
      }
      positions_.data()[strip.end++] = p.position;
    }
    close(strip);
  }

  // Appends the points of a strip of another slab whose coordinate along `axis` is in `range`.
  // `kept` is room for as many places as there are points in the strip.
  void append_part(const Strips& other, const Strip<Dimension>& strip, int axis,
                   const Range& range, Place* kept)
  {
    const double* x = other.columns_[axis].data();
    Place count = 0;
    for(Place i = strip.begin; i != strip.end; ++i) {
      kept[count] = i;
      count += static_cast<Place>(x[i] >= range.low) & static_cast<Place>(x[i] <= range.high);
    }
    Strip<Dimension> part{end_, end_ + count, strip.ranges};
    for(int each = 0; each < Dimension; ++each) {
      const double* from = other.columns_[each].data();
      double* to = columns_[each].data() + end_;
      for(Place k = 0; k < count; ++k)
        to[k] = from[kept[k]];
    }
    for(Place k = 0; k < count; ++k)
      positions_.data()[end_ + k] = other.positions_.data()[kept[k]];
    close(part);
  }

private:
  void close(const Strip<Dimension>& strip)
  {
    for(Place lane = 0; lane < lanes; ++lane)
      columns_[0].data()[strip.end + lane] = std::numeric_limits<double>::quiet_NaN();
    for(int axis = 1; axis < Dimension; ++axis) // not used, but read
      for(Place lane = 0; lane < lanes; ++lane)
        columns_[axis].data()[strip.end + lane] = 0;
    end_ = strip.end + lanes;
    if(strip.begin == strip.end)
      return;
    strips_.push_back(strip);
    size_ += strip.end - strip.begin;
    for(int axis = 0; axis < Dimension; ++axis) {
      ranges_[axis].add(strip.ranges[axis].low);
      ranges_[axis].add(strip.ranges[axis].high);
    }
  }

  std::array<Buffer<double>, Dimension> columns_;
  Buffer<Place> positions_;
  std::vector<Strip<Dimension>> strips_;
  std::array<Range, Dimension> ranges_;
  double crowd_ = 0;
  Place size_ = 0;
  Place end_ = 0; // of the places used
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_H
