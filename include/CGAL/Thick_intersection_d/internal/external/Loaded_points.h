// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H

// A part in memory.

#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Stripes.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Rows of cells in a box, across the last two axes, as slabs and strips are.
template <int Dimension>
class Tile_rows
{
public:
  explicit Tile_rows(const std::array<Interval, Dimension>& box)
  {
    for(std::size_t i = 0; i < 2; ++i) {
      const Interval& interval = box[Dimension - 1 - i];
      low_[i] = interval.low;
      scale_[i] = interval.length() > 0 ? side / interval.length() : 0; // zero if it is infinite
    }
  }

  static constexpr std::size_t size() { return std::size_t(side) * side; }

  std::size_t operator()(const std::array<double, Dimension>& x) const
  {
    return cell(x, 0) * side + cell(x, 1);
  }

private:
  static constexpr int side = 16;

  std::size_t cell(const std::array<double, Dimension>& x, std::size_t i) const
  {
    return static_cast<std::size_t>(
      cell_number((x[Dimension - 1 - i] - low_[i]) * scale_[i], side));
  }

  std::array<double, 2> low_;
  std::array<double, 2> scale_;
};

// The ids of points by their places. Their upper halves are null if all of them are zero. Ids of 32
// bits take half as many lines of the cache.
struct Halved_ids
{
  const std::uint32_t* low;
  const std::uint32_t* high;

  std::uint64_t operator[](std::size_t i) const
  {
    return high ? std::uint64_t(high[i]) << 32 | low[i] : low[i];
  }
};

// The points of a part, in the order in which a search sweeps them, roughly: it looks up the id of
// both points of each pair. In the order of the input, these ids are all over the memory, and
// looking them up takes longer than the search. Ids are in columns of their own.
template <int Dimension>
class Loaded_points
{
  using Record = Point_record<Dimension>;

public:
  // All ids are less than `ids_end`.
  explicit Loaded_points(std::uint64_t ids_end) : has_long_ids_(ids_end >> 32 != 0) {}

  const Stored_point<Dimension>* points() const { return points_.data(); }
  Halved_ids ids() const { return {low_ids_.data(), high_ids_.data()}; }
  std::size_t size() const { return size_; }

  // Forgets all points, and makes room for others.
  void clear(std::size_t room)
  {
    points_.require(room);
    low_ids_.require(room);
    if(has_long_ids_)
      high_ids_.require(room);
    size_ = 0;
  }

  void add(const Record* records, std::size_t count)
  {
    for(std::size_t i = 0; i < count; ++i)
      put(records[i], size_ + i);
    size_ += count;
  }

  // The same, row by row.
  void add_rows(const Tile_rows<Dimension>& rows, const Record* records, std::size_t count)
  {
    std::array<std::uint32_t, Tile_rows<Dimension>::size() + 1> begins = {};
    std::uint16_t* const cells = cells_.require(count);
    for(std::size_t i = 0; i < count; ++i) {
      cells[i] = static_cast<std::uint16_t>(rows(records[i].point.x));
      ++begins[cells[i] + 1];
    }
    for(std::size_t cell = 0; cell + 1 < begins.size(); ++cell)
      begins[cell + 1] += begins[cell];
    for(std::size_t i = 0; i < count; ++i)
      put(records[i], size_ + begins[cells[i]]++);
    size_ += count;
  }

private:
  void put(const Record& record, std::size_t place)
  {
    points_.data()[place] = record.point;
    low_ids_.data()[place] = static_cast<std::uint32_t>(record.id);
    if(has_long_ids_)
      high_ids_.data()[place] = static_cast<std::uint32_t>(record.id >> 32);
  }

  Buffer<Stored_point<Dimension>> points_;
  bool has_long_ids_;
  Buffer<std::uint32_t> low_ids_;
  Buffer<std::uint32_t> high_ids_;
  Buffer<std::uint16_t> cells_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
