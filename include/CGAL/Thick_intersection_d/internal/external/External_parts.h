// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_EXTERNAL_PARTS_H

// The parts of a set of points on disk, of which one is in memory at a time.

#include <CGAL/Memory_budget.h>

#include <CGAL/Thick_intersection_d/internal/external/Chunk_store.h>
#include <CGAL/Thick_intersection_d/internal/external/Loaded_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Part_limits.h>
#include <CGAL/Thick_intersection_d/internal/external/Point_columns.h>
#include <CGAL/Thick_intersection_d/internal/external/Stored_points.h>
#include <CGAL/Thick_intersection_d/internal/external/Streamed_sample.h>
#include <CGAL/Thick_intersection_d/internal/external/Tile_grid.h>
#include <CGAL/Thick_intersection_d/internal/external/Tile_writer.h>
#include <CGAL/Thick_intersection_d/internal/input/Interval.h>
#include <CGAL/Thick_intersection_d/internal/parts/Part_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

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
  using Sample = Streamed_sample<Point>;

  External_parts(const Memory_budget& budget, double reach)
    : limits_(budget.bytes(), stored_size<Dimension>), reach_(reach),
      store_(budget.directory(), limits_.points_per_chunk())
  {}

  const Part_limits& limits() const { return limits_; }

  // Takes the points that visit_points(visit) calls visit(point, id) for. A sample of some of them
  // tells where to cut.
  template <class Visit_points>
  void make(const Sample& sample, const Visit_points& visit_points)
  {
    const Tile_grid<Dimension> grid(sample.points(), limits_.tile_count());
    Tile_writer<Dimension> writer(grid, store_);
    visit_points([&](const Point& point, std::uint64_t id) { writer.add(point, id); });
    add_part(writer.finish(), grid.columns(), grid.axes());
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
    loaded.clear(static_cast<std::size_t>(part.size()));
    for(Points& tile : part.tiles) {
      const std::vector<Part*> near_parts = parts_near(closed_box(tile));
      const std::size_t first = loaded.size();
      loaded.add_owned(tile, store_);
      const Point_columns<Dimension> columns = loaded.columns();
      for(Part* other : near_parts)
        for(std::size_t i = first; i < loaded.size(); ++i)
          give(*other, columns.points[i], columns.ids[i]);
    }
    loaded.add_given(part.given, store_);
  }

private:
  // Return functions of an axis, as `Part_box` takes them.
  static auto ends_of(const Point& point)
  {
    return [&point](int axis) {
      return std::pair<double, double>(point.cartesian(axis), point.cartesian(axis));
    };
  }
  static auto ends_of(const Part_box& box)
  {
    return [&box](int axis) {
      const Interval& interval = box.intervals()[static_cast<std::size_t>(axis)];
      return std::pair<double, double>(interval.low, interval.high);
    };
  }

  static Part_box closed_box(const Points& points)
  {
    return Part_box({points.box().begin(), points.box().end()});
  }

  std::vector<Part*> parts_near(const Part_box& box)
  {
    std::vector<Part*> near_parts;
    for(Part& part : parts_)
      if(part.box.is_near(ends_of(box), reach_))
        near_parts.push_back(&part);
    return near_parts;
  }

  void give(Part& part, const Point& point, std::uint64_t id)
  {
    if(part.box.is_near(ends_of(point), reach_))
      part.given.add(store_, point, id);
  }

  // Adds a part in front of all others, unless it has no points.
  void add_part(std::vector<Points> tiles, std::size_t columns, std::array<std::size_t, 2> axes)
  {
    std::array<Interval, Dimension> box;
    std::uint64_t size = 0;
    for(const Points& tile : tiles) {
      for(std::size_t axis = 0; axis < Dimension; ++axis)
        box[axis].add(tile.box()[axis]);
      size += tile.size();
    }
    if(size != 0)
      parts_.push_back({std::move(tiles), columns, axes, Points(),
                        Part_box({box.begin(), box.end()}), size});
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
      cut_rows(part, rows_that_fit(part));
    part.given.take(store_, [&](const Point& point, std::uint64_t id) {
      for(std::size_t other = first; other < parts_.size(); ++other)
        give(parts_[other], point, id);
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

  // Returns how many rows can be searched at once, at least one and not all.
  std::size_t rows_that_fit(const Part& part) const
  {
    std::uint64_t size = part.given.size();
    std::size_t row = 0;
    for(; row + 1 < part.rows(); ++row) {
      for(std::size_t column = 0; column < part.columns; ++column)
        size += part.tiles[row * part.columns + column].size();
      if(row > 0 && size > limits_.points_per_search())
        break;
    }
    return row;
  }

  void cut_rows(Part& part, std::size_t rows)
  {
    const auto cut = part.tiles.begin() + static_cast<std::ptrdiff_t>(rows * part.columns);
    add_part({std::make_move_iterator(cut), std::make_move_iterator(part.tiles.end())},
             part.columns, part.axes);
    part.tiles.erase(cut, part.tiles.end());
    add_part(std::move(part.tiles), part.columns, part.axes);
  }

  void cut_columns(Part& part)
  {
    const std::size_t below = part.columns / 2;
    std::vector<Points> low, high;
    for(std::size_t tile = 0; tile < part.tiles.size(); ++tile) {
      const bool is_low = tile % part.columns < below;
      (is_low ? low : high).push_back(std::move(part.tiles[tile]));
    }
    add_part(std::move(high), part.columns - below, part.axes);
    add_part(std::move(low), below, part.axes);
  }

  // Refuses points that cannot be cut because they are equal.
  void cut_tile(Part& part)
  {
    Sample sample(limits_.points_per_sample());
    part.tiles[0].visit_some(store_, limits_.points_per_sample(),
                             [&](const Point& point) { sample.add(point); });
    make(sample, [&](const auto& visit) { part.tiles[0].take(store_, visit); });
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
