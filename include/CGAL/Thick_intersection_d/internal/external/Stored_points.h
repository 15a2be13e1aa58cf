// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H

// Lists of points that are too long for the memory.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/external/Scratch_file.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A point as searches read it, like a point of CGAL.
template <int Dimension>
struct Stored_point
{
  using Ambient_dimension = Dimension_tag<Dimension>;

  std::array<double, Dimension> x;

  int dimension() const { return Dimension; }
  double cartesian(int axis) const { return x[static_cast<std::size_t>(axis)]; }
};

// A point as it lies on disk.
template <int Dimension>
struct Point_record
{
  Stored_point<Dimension> point;
  std::uint64_t id; // its position in the user's range
};

// Places for chunks of points in a scratch file. Each has room for the same number of points. Lists
// get a row of places at a time, so that the numbers of their places take little memory. Rows that
// were released are used again.
template <int Dimension>
class Chunk_store
{
  using Record = Point_record<Dimension>;

public:
  static constexpr std::size_t places_per_row = 16;

  Chunk_store(const std::filesystem::path& directory, std::size_t points_per_chunk)
    : directory_(directory), points_per_chunk_(points_per_chunk)
  {}

  std::size_t points_per_chunk() const { return points_per_chunk_; }

  // The rows that were ever in use at the same time.
  std::uint32_t size() const { return size_; }

  std::uint32_t take_row()
  {
    if(free_.empty())
      return size_++;
    const std::uint32_t row = free_.back();
    free_.pop_back();
    return row;
  }

  void release(std::uint32_t row) { free_.push_back(row); }

  // Writes at most a chunk of points to a place of a row.
  void write(std::uint32_t row, std::size_t place, const Record* records, std::size_t count)
  {
    if(!file_)
      file_.emplace(directory_);
    file_->write(byte_of(row, place), records, count * sizeof(Record));
  }

  void read(std::uint32_t row, std::size_t place, Record* records, std::size_t count)
  {
    file_->read(byte_of(row, place), records, count * sizeof(Record));
  }

private:
  std::uint64_t byte_of(std::uint32_t row, std::size_t place) const
  {
    return (std::uint64_t(row) * places_per_row + place) * points_per_chunk_ * sizeof(Record);
  }

  std::filesystem::path directory_;
  std::size_t points_per_chunk_;
  std::optional<Scratch_file> file_; // none before it is needed
  std::uint32_t size_ = 0;
  std::vector<std::uint32_t> free_;
};

// A list of points, of which at most one chunk is in memory.
template <int Dimension>
class Stored_points
{
  using Record = Point_record<Dimension>;
  using Store = Chunk_store<Dimension>;

public:
  Stored_points() = default;

  // Begins with memory for a chunk, which stays with the caller, until flush().
  explicit Stored_points(Record* room, const Store& store)
    : last_(room), room_(store.points_per_chunk())
  {}

  std::uint64_t size() const { return size_before_last_ + last_size_; }

  // The intervals of the points that were written.
  const std::array<Interval, Dimension>& box() const { return box_; }

  void add(Store& store, const Stored_point<Dimension>& point, std::uint64_t id)
  {
    if(last_size_ == room_)
      make_room(store);
    last_[last_size_++] = {point, id};
  }

  // Writes what is in memory. Nothing can be added later.
  void flush(Store& store)
  {
    if(last_size_ != 0)
      write_last(store);
    last_ = nullptr;
    own_.reset();
  }

  // Calls visit(records, count) for all points, as many chunks at a time as have at most `most`
  // points, but at least one. They are in the order of add(). Leaves an empty list, and gives the
  // chunks back one by one.
  template <class Visit>
  void take(Store& store, std::size_t most, Buffer<Record>& buffer, const Visit& visit)
  {
    const std::size_t per_chunk = store.points_per_chunk();
    Record* const records = written_ == 0 ? nullptr : buffer.require((std::max)(most, per_chunk));
    std::size_t filled = 0;
    for(std::size_t chunk = 0; chunk < written_; ++chunk) {
      const bool is_last = chunk + 1 == written_;
      filled += read(store, chunk, records + filled);
      if(is_last || (chunk + 1) % Store::places_per_row == 0)
        store.release(rows_[chunk / Store::places_per_row]);
      if(is_last || filled + per_chunk > most) {
        visit(static_cast<const Record*>(records), filled);
        filled = 0;
      }
    }
    if(last_)
      visit(static_cast<const Record*>(last_), last_size_);
    *this = Stored_points();
  }

  // Calls visit(records, count) for some chunks at equal steps, of a list that was flushed.
  template <class Visit>
  void visit_some(Store& store, std::size_t most_chunks, const Visit& visit) const
  {
    Buffer<Record> buffer;
    Record* const records = buffer.require(store.points_per_chunk());
    for(std::size_t chunk = 0; chunk < written_; chunk += written_ / most_chunks + 1) {
      const std::size_t count = read(store, chunk, records);
      visit(static_cast<const Record*>(records), count);
    }
  }

private:
  void make_room(Store& store)
  {
    if(last_) {
      write_last(store);
      size_before_last_ += last_size_;
      last_size_ = 0;
    }
    else {
      room_ = store.points_per_chunk();
      own_ = make_uninitialized<Record>(room_);
      last_ = own_.get();
    }
  }

  // Returns how many points the chunk has. Only the last one may have room left, after flush().
  std::size_t read(Store& store, std::size_t chunk, Record* records) const
  {
    const bool is_flushed_last = !last_ && chunk + 1 == written_;
    const std::size_t count = is_flushed_last ? last_size_ : store.points_per_chunk();
    store.read(rows_[chunk / Store::places_per_row], chunk % Store::places_per_row, records, count);
    return count;
  }

  void write_last(Store& store)
  {
    std::array<Interval, Dimension> box = box_; // the compiler keeps a copy in registers
    for(std::size_t i = 0; i < last_size_; ++i)
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        box[axis].add(last_[i].point.x[axis]);
    box_ = box;
    const std::size_t place = written_++ % Store::places_per_row;
    if(place == 0)
      rows_.push_back(store.take_row());
    store.write(rows_.back(), place, last_, last_size_);
  }

  Record* last_ = nullptr;    // the last chunk, unless it was written
  std::size_t last_size_ = 0; // of the last chunk, wherever it is
  std::size_t room_ = 0;
  std::uint64_t size_before_last_ = 0;
  std::size_t written_ = 0;         // chunks
  std::vector<std::uint32_t> rows_; // where they are
  std::unique_ptr<Record[]> own_;
  std::array<Interval, Dimension> box_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
