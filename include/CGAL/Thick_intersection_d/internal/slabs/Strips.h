// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_H

// A slab that is ready for the sweep: strips of points, each sorted along axis 0. In the plane a
// slab is one strip. In space it is cut along axis 1.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Run.h>
#include <CGAL/Thick_intersection_d/internal/lanes/with_lanes.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slab_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The places [begin, end) of columns, and a box that holds the points there. For a border, it is
// the box of the strip that the border belongs to. For the points of one of two sets, it is the box
// of the points of both.
template <int Dimension>
struct Strip
{
  Place begin;
  Place end;
  Box_of_intervals<Dimension> box;
  Place sides; // a bit for the set that the points are of, if there are two sets

  Place size() const { return end - begin; }
};

template <class Point>
class Strips
{
  using Number = typename Point::Number;
  static constexpr int dimension = Point::dimension;

public:
  using Strip_of_points = Strip<dimension>;

  const std::vector<Strip_of_points>& strips() const { return strips_; }
  Place size() const { return size_; }
  const Interval& interval(int axis) const { return box_[axis]; }

  // The number of candidates, or an upper bound: pairs in one strip that are within a reach along
  // axis 0.
  double candidates() const { return candidates_; }
  void set_candidates(double candidates) { candidates_ = candidates; }

  typename Point::Run run(const Strip_of_points& strip) const
  {
    typename Point::Run run;
    for(int axis = 0; axis < dimension; ++axis)
      run.x[axis] = columns_[axis].data() + strip.begin;
    run.positions = positions_.data() + strip.begin;
    run.size = strip.size();
    return run;
  }

  // Returns the number of candidates.
  double count_candidates(double reach) const
  {
    const Number* const x = columns_[0].data();
    double count = 0;
    for(const Strip_of_points& strip : strips_)
      for(Place first = strip.begin, i = first; i != strip.end; ++i) {
        while(x[i] - x[first] > reach)
          ++first;
        count += i - first;
      }
    return count;
  }

  // Removes all strips, and makes room for `size` points in `count` strips.
  void reset(Place size, Place count)
  {
    const std::size_t places = size + static_cast<std::size_t>(count) * lanes;
    for(auto& column : columns_)
      column.require(places);
    positions_.require(places);
    strips_.clear();
    size_ = 0;
    end_ = 0;
    box_ = {};
  }

  // Appends a strip of the points [first, last), which are sorted along axis 0. If there are two
  // sets, or some of the points are in a border, appends a strip for each. Takes the bit of the
  // border away from positions.
  void append(const Point* first, const Point* last, const Point_sets& sets)
  {
    if(sets.are_two())
      for(const Place side : {1u, 2u})
        append_if(first, last, side, [&](Place position) {
          return (position < sets.first_size) == (side == 1);
        });
    else if(Point::may_be_shared && sets.have_border) {
      const auto append_side = [&](Place side) {
        return append_if(first, last, side, [&](Place& position) {
          const bool is_in_border = (position & Point_sets::border_bit) != 0;
          position &= Point_sets::border_bit - 1;
          return is_in_border == (side != 0);
        });
      };
      if(append_side(0) != last - first)
        append_side(Point_sets::side_of_border);
    }
    else
      append_if(first, last, 0, [](Place) { return true; });
  }

  // The number of points that are not in the border of a column.
  Place own_size() const
  {
    Place size = 0;
    for(const Strip_of_points& strip : strips_)
      size += strip.sides == Point_sets::side_of_border ? 0 : strip.size();
    return size;
  }

  // Appends the border of a strip of `other`: the points that meet `interval` along `axis`.
  void append_border(const Strips& other, const Strip_of_points& strip, int axis,
                     const Interval& interval)
  {
    const Number low = static_cast<Number>(interval.low); // both ends are numbers of this type
    const Number high = static_cast<Number>(interval.high);
    std::array<Number*, dimension> x;
    for(int c = 0; c < dimension; ++c)
      x[c] = columns_[c].data() + end_;
    Place count = 0;
    with_lanes([&](auto set) {
      count = set.copy_between(other.run(strip), axis, low, high, x, positions_.data() + end_);
    });
    close({end_, end_ + count, strip.box, strip.sides});
  }

  // The number of places that the strips and the ends of their runs take.
  Place place_count() const { return end_; }

  // Replaces the positions by the numbers from `first` on, one per place. Writes the positions to
  // `positions`.
  void number_places(Place first, Place* positions)
  {
    std::copy_n(positions_.data(), end_, positions);
    std::iota(positions_.data(), positions_.data() + end_, first);
  }

private:
  // Appends a strip of the points whose position is kept. Returns how many they are.
  template <class Keep>
  std::ptrdiff_t append_if(const Point* first, const Point* last, Place sides, const Keep& keep)
  {
    Strip_of_points strip{end_, end_, {}, sides};
    for(; first != last; ++first) {
      const Point& p = *first;
      for(int axis = 0; axis < dimension; ++axis) {
        columns_[axis].data()[strip.end] = p.x[axis];
        strip.box[axis].add(p.x[axis]);
      }
      Place position = p.position;
      const bool is_kept = keep(position);
      positions_.data()[strip.end] = position;
      strip.end += is_kept; // no branch: the next point takes the place of one not kept
    }
    close(strip);
    return strip.size();
  }

  // Writes the points that end a run (Run.h) behind a strip. Keeps the strip unless it is empty.
  void close(const Strip_of_points& strip)
  {
    for(Place lane = 0; lane < lanes; ++lane)
      columns_[0].data()[strip.end + lane] = end_of_run<Number>(lane);
    for(int axis = 1; axis < dimension; ++axis) // the sweep reads these, but does not use them
      for(Place lane = 0; lane < lanes; ++lane)
        columns_[axis].data()[strip.end + lane] = 0;
    end_ = strip.end + lanes;
    if(strip.size() == 0)
      return;
    strips_.push_back(strip);
    size_ += strip.size();
    for(int axis = 0; axis < dimension; ++axis)
      box_[axis].add(strip.box[axis]);
  }

  std::array<Buffer<Number>, dimension> columns_;
  Buffer<Place> positions_;
  std::vector<Strip_of_points> strips_;
  Box_of_intervals<dimension> box_;
  double candidates_ = 0;
  Place size_ = 0;
  Place end_ = 0; // the end of the used places
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_STRIPS_H
