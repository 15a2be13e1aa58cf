// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H

// A part in memory.

#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/external/Point_columns.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/input/positions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The points of a part: list by list, those that it owns first.
template <int Dimension>
class Loaded_points
{
  using List = Stored_points<Dimension>;
  using Store = Chunk_store<Dimension>;

public:
  std::size_t size() const { return size_; }
  std::size_t owned() const { return owned_; }
  Point_columns<Dimension> columns() const { return buffers_.columns(); }

  // Where the lists of owned points begin.
  const std::vector<Place>& begins() const { return begins_; }

  // Forgets all points, and makes room for others.
  void clear(std::size_t room)
  {
    buffers_.require(room);
    room_ = room;
    size_ = owned_ = 0;
    begins_.clear();
  }

  // Adds a point that the part owns, in the order of the range. Makes room for at most `most`.
  void add(const Stored_point<Dimension>& point, std::uint64_t id, std::size_t most)
  {
    if(size_ == 0)
      begins_.push_back(0);
    if(size_ == room_)
      grow((std::min)(most, 2 * size_ + (1 << 20)));
    columns().set(size_, point, id);
    owned_ = ++size_;
  }

  // Takes all points of a list. Those that the part owns come first.
  void add_owned(List& list, Store& store)
  {
    begins_.push_back(static_cast<Place>(size_));
    add_given(list, store);
    owned_ = size_;
  }

  void add_given(List& list, Store& store)
  {
    const std::size_t begin = size_;
    size_ += static_cast<std::size_t>(list.size());
    list.load(store, columns().from(begin));
  }

private:
  void grow(std::size_t room)
  {
    Column_buffers<Dimension> larger;
    larger.require(room);
    std::copy_n(columns().points, size_, larger.columns().points);
    std::copy_n(columns().ids, size_, larger.columns().ids);
    buffers_ = std::move(larger);
    room_ = room;
  }

  Column_buffers<Dimension> buffers_;
  std::size_t room_ = 0;
  std::size_t size_ = 0;
  std::size_t owned_ = 0;
  std::vector<Place> begins_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_LOADED_POINTS_H
