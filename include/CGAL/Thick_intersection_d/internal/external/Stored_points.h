// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H

// Lists of points that are too long for the memory, and the tiles that a sample cuts points into.

#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A list of points, of which at most one chunk is in memory.
template <int Dimension>
class Stored_points
{
  using Point = Stored_point<Dimension>;
  using Store = Chunk_store<Dimension>;

public:
  std::uint64_t size() const { return written_ + last_.size(); }

  // The box of the points that were written.
  Part_box box() const { return Part_box({box_.begin(), box_.end()}); }

  void add(Store& store, const Point& point)
  {
    if(last_.size() == store.points_per_chunk())
      write_last(store);
    if(last_.empty())
      last_.reserve(store.points_per_chunk());
    last_.push_back(point);
    prefetch_to_write(last_.data() + last_.size() + points_ahead);
  }

  // Writes what is in memory. Nothing can be added later.
  void flush(Store& store)
  {
    write_last(store);
    last_ = std::vector<Point>();
  }

  // Returns a point of a list that was flushed.
  Point read(Store& store, std::uint64_t place) const
  {
    Point point;
    read(store, place, &point, 1);
    return point;
  }

  // Appends all points to `points`, in the order of add(). Leaves an empty list.
  void load(Store& store, std::vector<Point>& points)
  {
    for(std::uint64_t first = 0; first < written_; first += store.points_per_chunk())
      take_chunk(store, first, points);
    points.insert(points.end(), last_.begin(), last_.end());
    *this = Stored_points();
  }

  // Calls visit(point) for all points, in the order of add(). Leaves an empty list.
  template <class Visit>
  void take(Store& store, const Visit& visit)
  {
    std::vector<Point> points;
    for(std::uint64_t first = 0; first < written_; first += store.points_per_chunk()) {
      points.clear();
      take_chunk(store, first, points);
      std::for_each(points.begin(), points.end(), visit);
    }
    std::for_each(last_.begin(), last_.end(), visit);
    *this = Stored_points();
  }

private:
  // How many points ahead the memory that they go to is prefetched.
  static constexpr std::size_t points_ahead = 8;

  // Reads points of one row, from a place of the list on.
  void read(Store& store, std::uint64_t place, Point* points, std::size_t count) const
  {
    const std::uint64_t row = place / store.points_per_row();
    store.read(rows_[static_cast<std::size_t>(row)], place % store.points_per_row(), points, count);
  }

  // Appends the points of a chunk, of which `first` is the first one. Gives chunks back row by row.
  void take_chunk(Store& store, std::uint64_t first, std::vector<Point>& points)
  {
    const std::uint64_t last = (std::min)(first + store.points_per_chunk(), written_);
    const std::size_t count = static_cast<std::size_t>(last - first);
    points.resize(points.size() + count);
    read(store, first, points.data() + points.size() - count, count);
    if(last == written_ || last % store.points_per_row() == 0)
      store.release(rows_[static_cast<std::size_t>(first / store.points_per_row())]);
  }

  void write_last(Store& store)
  {
    if(last_.empty())
      return;
    std::array<Interval, Dimension> box = box_; // the compiler keeps a copy in registers
    for(const Point& point : last_)
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        box[axis].add(point.x[axis]);
    box_ = box;
    const std::uint64_t place = written_ % store.points_per_row();
    if(place == 0)
      rows_.push_back(store.take_row());
    store.write(rows_.back(), place, last_.data(), last_.size());
    written_ += last_.size();
    last_.clear();
  }

  std::vector<Point> last_;         // the last chunk, unless it was written
  std::uint64_t written_ = 0;       // points: whole chunks, before flush()
  std::vector<std::uint32_t> rows_; // where they are
  std::array<Interval, Dimension> box_;
};

// Finds the stripe of a number. Numbers in order have stripes in order.
class Stripes
{
public:
  // `values` are in order. Some of them are below a cut, and some are not, unless all are equal.
  // `count` is a power of two.
  Stripes(const std::vector<double>& values, std::size_t count)
    : cuts_(1, -std::numeric_limits<double>::infinity())
  {
    for(std::size_t stripe = 1; stripe < count; ++stripe)
      cuts_.push_back(values[stripe * values.size() / count]);
    if(cuts_.back() == values.front())
      cuts_.back() = values.back();
  }

  // Returns the last stripe that begins with x or a lesser number. There is no branch: it would be
  // mispredicted for half of the numbers.
  std::size_t operator()(double x) const
  {
    std::size_t stripe = 0;
    for(std::size_t step = cuts_.size() / 2; step > 0; step /= 2)
      stripe += step * (cuts_[stripe + step] <= x); // x is less than cuts_[stripe + 2 * step]
    return stripe;
  }

private:
  std::vector<double> cuts_; // where stripes begin
};

// Rows of tiles, cut across two axes. The sample decides where to cut and nothing else: every point
// has one tile, whatever the sample was. A search cuts slabs across the last axis, and strips
// across the one before it. So tiles that follow each other are searched after each other.
//
// Points wait until there are some hundreds of them. Then two short loops find their tiles and copy
// them there, while the memory that they go to is on its way to the cache.
template <int Dimension>
class Tile_writer
{
  using Point = Stored_point<Dimension>;
  using Points = Stored_points<Dimension>;
  using Store = Chunk_store<Dimension>;

public:
  // Few, because a part that is cut into rows alone has few points near others.
  static constexpr std::size_t columns = 4;

  // Needs a point of the sample. The number of tiles is a power of two.
  Tile_writer(const std::vector<Point>& sample, std::size_t tile_count, Store& store)
    : store_(store), tiles_(tile_count)
  {
    std::array<std::vector<double>, Dimension> values;
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      for(const Point& point : sample)
        values[axis].push_back(point.x[axis]);
      std::sort(values[axis].begin(), values[axis].end());
    }
    choose_axes(values);
    stripes_.emplace_back(values[axes_[0]], tile_count / columns);
    stripes_.emplace_back(values[axes_[1]], columns);
  }

  // The axis across which rows are cut, and that across which columns are.
  const std::array<std::size_t, 2>& axes() const { return axes_; }

  void add(const Point& point)
  {
    waiting_.push_back(point);
    if(waiting_.size() == most_waiting)
      write_waiting();
  }

  // Returns the tiles, row by row, all of them on disk.
  std::vector<Points> finish()
  {
    write_waiting();
    for(Points& tile : tiles_)
      tile.flush(store_);
    return std::move(tiles_);
  }

private:
  static constexpr std::size_t most_waiting = 512;

  // Takes the two axes along which most points extend most, and all points if most are equal. Of
  // lengths that are alike, those of later axes are better.
  void choose_axes(const std::array<std::vector<double>, Dimension>& values)
  {
    std::array<std::pair<int, int>, Dimension> lengths;
    std::array<std::size_t, Dimension> order;
    for(std::size_t axis = 0; axis < Dimension; ++axis) {
      const std::vector<double>& x = values[axis];
      const std::size_t outliers = x.size() / 64;
      const double most = x[x.size() - 1 - outliers] / 2 - x[outliers] / 2;
      const double all = x.back() / 2 - x.front() / 2;
      lengths[axis] = {std::ilogb(most), std::ilogb(all)};
      order[axis] = Dimension - 1 - axis;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return lengths[i] > lengths[j]; });
    axes_ = {order[0], order[1]};
  }

  void write_waiting()
  {
    std::array<std::uint32_t, most_waiting> tile_of;
    for(std::size_t i = 0; i < waiting_.size(); ++i) {
      const Point& point = waiting_[i];
      tile_of[i] = static_cast<std::uint32_t>(stripes_[0](point.x[axes_[0]]) * columns
                                              + stripes_[1](point.x[axes_[1]]));
    }
    for(std::size_t i = 0; i < waiting_.size(); ++i)
      tiles_[tile_of[i]].add(store_, waiting_[i]);
    waiting_.clear();
  }

  Store& store_;
  std::vector<Points> tiles_;
  std::array<std::size_t, 2> axes_;
  std::vector<Stripes> stripes_; // rows, columns
  std::vector<Point> waiting_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
