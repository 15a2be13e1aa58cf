// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H

// Chunks of points on disk.

#include <CGAL/Thick_intersection_d/internal/external/Point_columns.h>
#include <CGAL/Thick_intersection_d/internal/external/Scratch_file.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Places for chunks of points in a scratch file. Each has room for the same number of points. Lists
// get a row of places at a time, so that the numbers of their places take little memory. Rows that
// were released are used again.
template <int Dimension>
class Chunk_store
{
  using Columns = Point_columns<Dimension>;

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
  void write(std::uint32_t row, std::size_t place, const Columns& columns, std::size_t count)
  {
    if(!file_)
      file_.emplace(directory_);
    const std::uint64_t byte = byte_of(row, place);
    file_->write(byte, columns.points, count * sizeof *columns.points);
    file_->write(byte + bytes_of_points(), columns.ids, count * sizeof *columns.ids);
  }

  void read_points(std::uint32_t row, std::size_t place, Stored_point<Dimension>* points,
                   std::size_t count)
  {
    file_->read(byte_of(row, place), points, count * sizeof *points);
  }

  void read(std::uint32_t row, std::size_t place, const Columns& columns, std::size_t count)
  {
    read_points(row, place, columns.points, count);
    file_->read(byte_of(row, place) + bytes_of_points(), columns.ids, count * sizeof *columns.ids);
  }

private:
  std::uint64_t byte_of(std::uint32_t row, std::size_t place) const
  {
    return (std::uint64_t(row) * places_per_row + place) * points_per_chunk_
           * stored_size<Dimension>;
  }

  std::uint64_t bytes_of_points() const
  {
    return points_per_chunk_ * sizeof(Stored_point<Dimension>);
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
