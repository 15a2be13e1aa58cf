// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_CHUNK_STORE_H

// Points on disk: chunks of them in a file that lives as long as an object.

#include <CGAL/Dimension.h>

#include <CGAL/Thick_intersection_d/internal/machine/private_file.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Searches read it like a point of CGAL.
template <int Dimension>
struct Stored_point
{
  using Ambient_dimension = Dimension_tag<Dimension>;

  Stored_point() {} // sets nothing: a vector of points that will be read is touched once
  Stored_point(const std::array<double, Dimension>& coordinates, std::uint64_t position)
    : x(coordinates), id(position)
  {}

  int dimension() const { return Dimension; }
  double cartesian(int axis) const { return x[static_cast<std::size_t>(axis)]; }
  std::pair<double, double> bounds_along(int axis) const
  {
    return {cartesian(axis), cartesian(axis)};
  }

  std::array<double, Dimension> x;
  std::uint64_t id; // its position in the user's range
};

// A file that has a name only for a moment, where the system allows this: then no file stays, even
// if the process is killed. Elsewhere, the destructor removes the file.
class Scratch_file
{
public:
  // Throws std::system_error if no file can be made in the directory.
  explicit Scratch_file(const std::filesystem::path& directory) : directory_(directory)
  {
    using std::ios_base;
    make_empty_file();
    const bool is_open
      = file_.open(path_, ios_base::in | ios_base::out | ios_base::binary) != nullptr;
    const int error = errno;
    remove_name(); // nothing stays if it is not open, either
    errno = error;
    if(!is_open)
      fail("opened");
  }

  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;

  ~Scratch_file()
  {
    file_.close();
    if(!path_.empty())
      remove_name();
  }

  // Throw std::system_error, such as for a full disk.
  void write(std::uint64_t place, const void* bytes, std::size_t count)
  {
    const auto wanted = static_cast<std::streamsize>(count);
    if(!seek(place) || file_.sputn(static_cast<const char*>(bytes), wanted) != wanted)
      fail("written");
  }
  void read(std::uint64_t place, void* bytes, std::size_t count)
  {
    const auto wanted = static_cast<std::streamsize>(count);
    if(!seek(place) || file_.sgetn(static_cast<char*>(bytes), wanted) != wanted)
      fail("read");
  }

private:
  // Makes a file that did not exist: another process may look for a name at the same time, or for
  // points of another user.
  void make_empty_file()
  {
    const auto start = std::chrono::system_clock::now().time_since_epoch().count();
    for(int attempt = 0; attempt < 1000; ++attempt) {
      path_ = directory_ / ("thick_intersection_d_" + std::to_string(start) + "_"
                            + std::to_string(attempt));
      errno = 0;
      if(make_private_file(path_.string().c_str()))
        return;
      if(errno != EEXIST)
        break;
    }
    fail("made");
  }

  void remove_name()
  {
    std::error_code error;
    if(std::filesystem::remove(path_, error))
      path_.clear();
  }

  // Also writes what is still in the buffer of the stream.
  bool seek(std::uint64_t place)
  {
    errno = 0;
    return file_.pubseekpos(std::streampos(static_cast<std::streamoff>(place)))
           != std::streampos(std::streamoff(-1));
  }

  [[noreturn]] void fail(const char* what) const
  {
    throw std::system_error(errno == 0 ? EIO : errno, std::generic_category(),
                            "The scratch file in " + directory_.string() + " cannot be " + what);
  }

  std::filesystem::path directory_;
  std::filesystem::path path_; // empty if the file has no name
  std::filebuf file_;
};

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
