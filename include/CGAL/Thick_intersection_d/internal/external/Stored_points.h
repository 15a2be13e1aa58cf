// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H

// Lists of points that are too long for the memory.

#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
  // How many points ahead the memory that they go to is asked for.
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

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
