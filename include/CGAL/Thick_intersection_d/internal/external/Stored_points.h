// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H

// Lists of points that are too long for the memory.

#include <CGAL/Thick_intersection_d/internal/external/Scratch_file.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A point as it lies on disk: its coordinates and its position in the user's range.
struct Stored_point
{
  std::array<double, 3> x;
  std::uint64_t id;
};

// Places for chunks of points in a scratch file. Each has room for the same number of points.
// Places that were released are used again.
class Chunk_store
{
public:
  Chunk_store(const std::filesystem::path& directory, std::size_t points_per_chunk)
    : directory_(directory), points_per_chunk_(points_per_chunk)
  {}

  std::size_t points_per_chunk() const { return points_per_chunk_; }

  // The places that were ever in use at the same time.
  std::uint64_t size() const { return size_; }

  // Writes at most a chunk of points and returns its place.
  std::uint64_t put(const std::vector<Stored_point>& points)
  {
    if(!file_)
      file_.emplace(directory_);
    const std::uint64_t place = free_.empty() ? size_++ : free_.back();
    if(!free_.empty())
      free_.pop_back();
    file_->write(byte_of(place), points.data(), points.size() * sizeof(Stored_point));
    return place;
  }

  // Reads points.size() points of the chunk at a place.
  void read(std::uint64_t place, std::vector<Stored_point>& points)
  {
    file_->read(byte_of(place), points.data(), points.size() * sizeof(Stored_point));
  }

  void release(std::uint64_t place) { free_.push_back(place); }

private:
  std::uint64_t byte_of(std::uint64_t place) const
  {
    return place * points_per_chunk_ * sizeof(Stored_point);
  }

  std::filesystem::path directory_;
  std::size_t points_per_chunk_;
  std::optional<Scratch_file> file_; // none before it is needed
  std::uint64_t size_ = 0;
  std::vector<std::uint64_t> free_;
};

// A list of points, of which at most one chunk is in memory.
class Stored_points
{
public:
  std::uint64_t size() const { return size_; }

  void add(Chunk_store& store, const Stored_point& point)
  {
    if(buffer_.empty())
      buffer_.reserve(store.points_per_chunk());
    buffer_.push_back(point);
    ++size_;
    if(buffer_.size() == store.points_per_chunk())
      write_buffer(store);
  }

  // Writes what is in memory.
  void flush(Chunk_store& store)
  {
    if(!buffer_.empty())
      write_buffer(store);
    std::vector<Stored_point>().swap(buffer_);
  }

  // Calls visit(points) for the points of each chunk, a vector, in the order of add().
  template <class Visit>
  void visit_chunks(Chunk_store& store, const Visit& visit) const
  {
    visit_and_leave(store, visit, [](std::uint64_t) {});
  }

  // The same. Leaves an empty list, and gives the chunks back one by one.
  template <class Visit>
  void take_chunks(Chunk_store& store, const Visit& visit)
  {
    visit_and_leave(store, visit, [&](std::uint64_t place) { store.release(place); });
    *this = Stored_points();
  }

private:
  struct Chunk
  {
    std::uint64_t place;
    std::size_t size;
  };

  void write_buffer(Chunk_store& store)
  {
    chunks_.push_back({store.put(buffer_), buffer_.size()});
    buffer_.clear();
  }

  template <class Visit, class Leave>
  void visit_and_leave(Chunk_store& store, const Visit& visit, const Leave& leave) const
  {
    std::vector<Stored_point> points;
    for(const Chunk& chunk : chunks_) {
      points.resize(chunk.size);
      store.read(chunk.place, points);
      leave(chunk.place);
      visit(points);
    }
    points = buffer_;
    visit(points);
  }

  std::vector<Chunk> chunks_;
  std::vector<Stored_point> buffer_;
  std::uint64_t size_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_STORED_POINTS_H
