// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H

// Lists of points that are too long for the memory.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/external/Point_columns.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/machine/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A list of points, of which at most one chunk is in memory.
template <int Dimension>
class Stored_points
{
  using Columns = Point_columns<Dimension>;
  using Store = Chunk_store<Dimension>;

public:
  Stored_points() = default;

  // Begins with memory for a chunk, which stays with the caller, until flush().
  Stored_points(const Columns& room, const Store& store)
    : last_(room), room_(store.points_per_chunk())
  {}

  std::uint64_t size() const { return size_before_last_ + last_size_; }

  // The intervals of the points that were written.
  const std::array<Interval, Dimension>& box() const { return box_; }

  void add(Store& store, const Stored_point<Dimension>& point, std::uint64_t id)
  {
    if(last_size_ == room_)
      make_room(store);
    last_.set(last_size_++, point, id);
    prefetch_to_write(last_.points + last_size_ + points_ahead);
    prefetch_to_write(last_.ids + last_size_ + points_ahead);
  }

  // Writes what is in memory. Nothing can be added later.
  void flush(Store& store)
  {
    if(last_size_ != 0)
      write_last(store);
    last_ = {};
    own_.reset();
  }

  // Copies all points to `columns`, in the order of add(). Leaves an empty list.
  void load(Store& store, Columns columns)
  {
    take_chunks(store, [&](std::size_t chunk) {
      columns = columns.from(read(store, chunk, columns));
    });
    if(last_.points) {
      std::copy_n(last_.points, last_size_, columns.points);
      std::copy_n(last_.ids, last_size_, columns.ids);
    }
    *this = Stored_points();
  }

  // Calls visit(point, id) for all points, in the order of add(). Leaves an empty list.
  template <class Visit>
  void take(Store& store, const Visit& visit)
  {
    Column_buffers<Dimension> buffers;
    const auto visit_some = [&](const Columns& columns, std::size_t count) {
      for(std::size_t i = 0; i < count; ++i)
        visit(columns.points[i], columns.ids[i]);
    };
    take_chunks(store, [&](std::size_t chunk) {
      buffers.require(store.points_per_chunk());
      visit_some(buffers.columns(), read(store, chunk, buffers.columns()));
    });
    if(last_.points)
      visit_some(last_, last_size_);
    *this = Stored_points();
  }

  // Calls visit(point) for the points of some chunks at equal steps, of a list that was flushed.
  template <class Visit>
  void visit_some(Store& store, std::size_t most_chunks, const Visit& visit) const
  {
    Buffer<Stored_point<Dimension>> buffer;
    Stored_point<Dimension>* const points = buffer.require(store.points_per_chunk());
    for(std::size_t chunk = 0; chunk < written_; chunk += written_ / most_chunks + 1) {
      const std::size_t count = size_of(store, chunk);
      store.read_points(row_of(chunk), chunk % Store::places_per_row, points, count);
      std::for_each(points, points + count, visit);
    }
  }

private:
  // How many points ahead the memory that they go to is asked for.
  static constexpr std::size_t points_ahead = 8;

  void make_room(Store& store)
  {
    if(last_.points) {
      write_last(store);
      size_before_last_ += last_size_;
      last_size_ = 0;
    }
    else {
      room_ = store.points_per_chunk();
      own_ = std::make_unique<Column_buffers<Dimension>>();
      own_->require(room_);
      last_ = own_->columns();
    }
  }

  // Calls visit(chunk) for the chunks that were written. Gives them back row by row.
  template <class Visit>
  void take_chunks(Store& store, const Visit& visit)
  {
    for(std::size_t chunk = 0; chunk < written_; ++chunk) {
      visit(chunk);
      if(chunk + 1 == written_ || (chunk + 1) % Store::places_per_row == 0)
        store.release(row_of(chunk));
    }
  }

  std::uint32_t row_of(std::size_t chunk) const { return rows_[chunk / Store::places_per_row]; }

  // Only the last chunk may have room left, after flush().
  std::size_t size_of(const Store& store, std::size_t chunk) const
  {
    const bool is_flushed_last = !last_.points && chunk + 1 == written_;
    return is_flushed_last ? last_size_ : store.points_per_chunk();
  }

  // Returns how many points the chunk has.
  std::size_t read(Store& store, std::size_t chunk, const Columns& columns) const
  {
    const std::size_t count = size_of(store, chunk);
    store.read(row_of(chunk), chunk % Store::places_per_row, columns, count);
    return count;
  }

  void write_last(Store& store)
  {
    std::array<Interval, Dimension> box = box_; // the compiler keeps a copy in registers
    for(std::size_t i = 0; i < last_size_; ++i)
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        box[axis].add(last_.points[i].x[axis]);
    box_ = box;
    const std::size_t place = written_++ % Store::places_per_row;
    if(place == 0)
      rows_.push_back(store.take_row());
    store.write(rows_.back(), place, last_, last_size_);
  }

  Columns last_ = {};         // the last chunk, unless it was written
  std::size_t last_size_ = 0; // of the last chunk, wherever it is
  std::size_t room_ = 0;
  std::uint64_t size_before_last_ = 0;
  std::size_t written_ = 0;         // chunks
  std::vector<std::uint32_t> rows_; // where they are
  std::unique_ptr<Column_buffers<Dimension>> own_;
  std::array<Interval, Dimension> box_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
