// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_TILE_WRITER_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_TILE_WRITER_H

// Writes points to the tiles that they are in.

#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/external/Point_columns.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Tile_grid.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Points wait until there are some hundreds of them. Then two short loops find their tiles and copy
// them there, while the memory that they go to is on its way to the cache.
template <int Dimension>
class Tile_writer
{
  using Points = Stored_points<Dimension>;
  using Store = Chunk_store<Dimension>;

public:
  Tile_writer(const Tile_grid<Dimension>& grid, Store& store) : grid_(grid), store_(store)
  {
    waiting_.require(most_waiting);
    room_.require(grid.size() * store.points_per_chunk());
    for(std::size_t tile = 0; tile < grid.size(); ++tile)
      tiles_.emplace_back(room_.columns().from(tile * store.points_per_chunk()), store);
  }

  void add(const Stored_point<Dimension>& point, std::uint64_t id)
  {
    waiting_.columns().set(count_, point, id);
    if(++count_ == most_waiting)
      write_waiting();
  }

  // Returns the tiles, all of them on disk.
  std::vector<Points> finish()
  {
    write_waiting();
    for(Points& tile : tiles_)
      tile.flush(store_);
    return std::move(tiles_);
  }

private:
  static constexpr std::size_t most_waiting = 512;

  void write_waiting()
  {
    const Point_columns<Dimension> columns = waiting_.columns();
    for(std::size_t i = 0; i < count_; ++i)
      tile_of_[i] = static_cast<std::uint32_t>(grid_(columns.points[i]));
    for(std::size_t i = 0; i < count_; ++i)
      tiles_[tile_of_[i]].add(store_, columns.points[i], columns.ids[i]);
    count_ = 0;
  }

  const Tile_grid<Dimension>& grid_;
  Store& store_;
  Column_buffers<Dimension> room_; // of the last chunk of each tile
  std::vector<Points> tiles_;
  Column_buffers<Dimension> waiting_;
  std::array<std::uint32_t, most_waiting> tile_of_;
  std::size_t count_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_TILE_WRITER_H
