// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H

// The parts of a set of points on disk, of which one is in memory at a time.

#include <CGAL/Memory_budget.h>

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/external/Searched_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>
#include <CGAL/Thick_intersection_d/internal/parts/Point_sample.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// How a budget of memory is shared.
class Part_limits
{
public:
  // `point_size` is that of a point with its id.
  Part_limits(std::size_t bytes, std::size_t point_size) : bytes_(bytes), point_size_(point_size) {}

  // Tiles have a chunk in memory each. All of these share an eighth of the budget.
  std::size_t tile_count() const { return bytes_ < most_tiles << 16 ? 64 : most_tiles; }

  // Large chunks are written and read faster: 10^7 points in the plane took 1.3 times as long with
  // 512 points each. Pages hold whole chunks where the budget allows this.
  std::size_t points_per_chunk() const
  {
    const std::size_t fair = bytes_ / 8 / (tile_count() * point_size_);
    const std::size_t of_pages = fair < points_per_pages ? fair : fair / points_per_pages
                                                                   * points_per_pages;
    return (std::min)((std::max)(of_pages, std::size_t(4)), std::size_t(4096));
  }

  // The points of a sample, which takes a sixteenth of the budget, with the cuts made of it.
  std::size_t points_per_sample() const
  {
    const std::size_t fair = bytes_ / 16 / 64 & ~std::size_t(1);
    return (std::min)(fair, std::size_t(1) << 13);
  }

  // The points that are searched at the same time. A search takes up to 30 bytes for each of them
  // (benchmark/results.md, memory), or up to 80 if very many pairs are near ties: smaller parts for
  // these would take longer in all scenes. It has places for less than half as many as places can
  // tell apart.
  std::size_t points_per_search() const
  {
    return (std::min)(bytes_ / 16 * 13 / (point_size_ + 30), std::size_t(max_place / 2 - 1));
  }

private:
  static constexpr std::size_t most_tiles = 128;
  static constexpr std::size_t points_per_pages = 512;

  std::size_t bytes_;
  std::size_t point_size_;
};

[[noreturn]] inline void refuse_crowd(std::size_t points_per_search)
{
  throw std::length_error("The points near a part of the points do not fit in the memory budget, "
                          "which has room for " + std::to_string(points_per_search)
                          + " points: take a larger budget or a smaller bound.");
}

// Each point is owned by one part. The parts are searched one after another. A part that has been
// searched gives its points to those that are still to come: each of them to all parts near it. So
// a part is searched with the points that it owns and points of parts before it. Of two near points
// of different parts, the one whose part comes first is there when the other part is searched, and
// at no other time: the pair is found, and found once.
//
// The points are written once, to tiles. All tiles are one part at first. A part that does not fit
// in memory is cut between tiles, or into new tiles if it has a single one. The parts that it
// becomes take its place in the order, and the points that it was given go to those of them that
// they are near. So nothing above changes, and the parts before it need not know. A part is cut
// when all parts before it have been searched, so all that it was given is known.
template <int Dimension>
class External_parts
{
  using Point = Stored_point<Dimension>;
  using Points = Stored_points<Dimension>;

  struct Part
  {
    std::vector<Points> tiles; // row by row; they have the points that the part owns
    std::size_t columns;
    std::array<std::size_t, 2> axes; // across which rows and columns are cut
    Points given;
    Part_box box; // of the owned points
    std::uint64_t owned;

    std::uint64_t size() const { return owned + given.size(); }
    std::size_t rows() const { return tiles.size() / columns; }
    double length(std::size_t i) const { return box.intervals()[axes[i]].half_length(); }
  };

public:
  External_parts(const Memory_budget& budget, double reach)
    : limits_(budget.bytes(), sizeof(Point)), reach_(reach),
      store_(budget.directory(), limits_.points_per_chunk())
  {}

  const Part_limits& limits() const { return limits_; }

  // Takes the points that visit_points(visit) calls visit(point) for. Some of the first `size` ones
  // tell where to cut; point_at(i) returns them.
  template <class Point_at, class Visit_points>
  void make(std::uint64_t size, const Point_at& point_at, const Visit_points& visit_points)
  {
    std::vector<Point> sample;
    for_random_positions(size, limits_.points_per_sample(),
                         [&](std::uint64_t i) { sample.push_back(point_at(i)); });
    Tile_writer<Dimension> writer(sample, limits_.tile_count(), store_);
    visit_points([&](const Point& point) { writer.add(point); });
    add_part(writer.finish(), writer.columns, writer.axes());
  }

  // Gets the next part ready to be taken. Returns false if there is none.
  bool find_next()
  {
    while(!parts_.empty() && parts_.back().size() > limits_.points_per_search())
      cut_last();
    return !parts_.empty();
  }

  // Takes the part away, and gives its points to the parts behind it.
  void take_next(Loaded_points<Dimension>& loaded)
  {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    std::vector<Point>& points = loaded.points;
    points.clear();
    reserve_huge_pages(points, static_cast<std::size_t>(part.size()));
    loaded.begins.clear();
    for(Points& tile : part.tiles) {
      const Part_box box = tile.box();
      std::vector<Part*> near_parts;
      for(Part& other : parts_)
        if(other.box.is_near(box, reach_))
          near_parts.push_back(&other);
      loaded.begins.push_back(points.size());
      tile.load(store_, points);
      for(Part* other : near_parts)
        for(std::size_t i = loaded.begins.back(); i < points.size(); ++i)
          give(*other, points[i]);
    }
    loaded.owned = points.size();
    part.given.load(store_, points);
  }

private:
  void give(Part& part, const Point& point)
  {
    if(part.box.is_near(point, reach_))
      part.given.add(store_, point);
  }

  // Adds a part in front of all others, unless it has no points.
  void add_part(std::vector<Points> tiles, std::size_t columns, std::array<std::size_t, 2> axes)
  {
    Part_box box(Dimension);
    std::uint64_t size = 0;
    for(const Points& tile : tiles) {
      box.add(tile.box());
      size += tile.size();
    }
    if(size != 0)
      parts_.push_back({std::move(tiles), columns, axes, Points(), std::move(box), size});
  }

  // Parts become smaller by each cut. One that has few points of its own would not by another.
  void cut_last()
  {
    Part part = std::move(parts_.back());
    parts_.pop_back();
    if(part.owned < limits_.points_per_search() / 16)
      refuse_crowd(limits_.points_per_search());
    const std::size_t first = parts_.size();
    if(part.tiles.size() == 1)
      cut_tile(part);
    else if(part.rows() == 1 || (part.columns > 1 && are_rows_flat(part)))
      cut_columns(part);
    else
      cut_rows(part);
    part.given.take(store_, [&](const Point& point) {
      for(std::size_t other = first; other < parts_.size(); ++other)
        give(parts_[other], point);
    });
  }

  // Whether parts of whole rows would be far longer than high, with most of their points near
  // others.
  bool are_rows_flat(const Part& part) const
  {
    const double share
      = static_cast<double>(limits_.points_per_search()) / static_cast<double>(part.size());
    return 8 * share * part.length(0) < part.length(1);
  }

  // Cuts off as many rows as can be searched at once, at least one and not all.
  void cut_rows(Part& part)
  {
    std::uint64_t size = part.given.size();
    std::size_t row = 0;
    for(; row + 1 < part.rows(); ++row) {
      for(std::size_t column = 0; column < part.columns; ++column)
        size += part.tiles[row * part.columns + column].size();
      if(row > 0 && size > limits_.points_per_search())
        break;
    }
    cut_between_tiles(part, part.columns, part.columns,
                      [&](std::size_t tile) { return tile < row * part.columns; });
  }

  void cut_columns(Part& part)
  {
    const std::size_t below = part.columns / 2;
    cut_between_tiles(part, below, part.columns - below,
                      [&](std::size_t tile) { return tile % part.columns < below; });
  }

  // Makes a part of the tiles that are low, and one behind it of the others.
  template <class Is_low>
  void cut_between_tiles(Part& part, std::size_t low_columns, std::size_t high_columns,
                         const Is_low& is_low)
  {
    std::vector<Points> low, high;
    for(std::size_t tile = 0; tile < part.tiles.size(); ++tile)
      (is_low(tile) ? low : high).push_back(std::move(part.tiles[tile]));
    add_part(std::move(high), high_columns, part.axes);
    add_part(std::move(low), low_columns, part.axes);
  }

  // Refuses points that cannot be cut because they are equal.
  void cut_tile(Part& part)
  {
    Points& points = part.tiles[0];
    make(points.size(), [&](std::uint64_t i) { return points.read(store_, i); },
         [&](const auto& visit) { points.take(store_, visit); });
    for(const Points& tile : parts_.back().tiles)
      if(tile.size() == part.owned)
        refuse_crowd(limits_.points_per_search());
  }

  Part_limits limits_;
  double reach_;
  Chunk_store<Dimension> store_;
  std::vector<Part> parts_; // the next one last
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H
