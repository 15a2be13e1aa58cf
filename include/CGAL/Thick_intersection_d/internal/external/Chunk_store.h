// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H

// Chunks of points in a file.

#include <CGAL/Thick_intersection_d/internal/external/Scratch_file.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_point.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Rows of chunks of points in a scratch file. All chunks are of the same size. Lists get a row at a
// time, so that the numbers of their rows take little memory. Rows that were released are used
// again.
template <int Dimension>
class Chunk_store
{
  using Point = Stored_point<Dimension>;

public:
  Chunk_store(const std::filesystem::path& directory, std::size_t points_per_chunk)
    : directory_(directory), points_per_chunk_(points_per_chunk)
  {}

  std::uint64_t points_per_chunk() const { return points_per_chunk_; }
  std::uint64_t points_per_row() const { return chunks_per_row * points_per_chunk_; }

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

  // `place` is that of the first point in its row.
  void write(std::uint32_t row, std::uint64_t place, const Point* points, std::size_t count)
  {
    if(!file_)
      file_.emplace(directory_);
    file_->write(byte_of(row, place), points, count * sizeof *points);
  }

  void read(std::uint32_t row, std::uint64_t place, Point* points, std::size_t count)
  {
    file_->read(byte_of(row, place), points, count * sizeof *points);
  }

private:
  static constexpr std::uint64_t chunks_per_row = 16;

  std::uint64_t byte_of(std::uint32_t row, std::uint64_t place) const
  {
    return (row * points_per_row() + place) * sizeof(Point);
  }

  std::filesystem::path directory_;
  std::size_t points_per_chunk_;
  std::optional<Scratch_file> file_; // none before it is needed
  std::uint32_t size_ = 0;
  std::vector<std::uint32_t> free_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H
