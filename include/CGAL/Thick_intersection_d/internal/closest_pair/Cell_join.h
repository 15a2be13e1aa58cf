// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H

// Visits all pairs of points within a distance d. It visits few other pairs, as long as few points
// have a neighbor that near. This is the fast way to the closest pair and to a close pair, in the
// plane and in space.
//
// The cells are those of [L] (Closest_pair_search.h). But a point enters several cells, and cells
// are not compared with adjacent cells. Every point enters the cells that its cube of side d meets:
// the points within d/2 of it along each axis. The cubes of two points within d meet, so both
// points enter a common cell. Cells are 2 to 16 d long, so points enter few cells, most points only
// one.
//
// The upper bits of the hash of the cell distribute the entries over lists, as in radix sort. A
// list fits in the cache, and a hash table finds the cells in it. The join moves no coordinate, and
// looks again only at points in a common cell.
//
// In fixed dimension a point enters O(1) cells (Hashed_cells.h). An entry is compared with those in
// the same place of the hash table. Of these, expected O(1) are of other cells, for any points and
// a random seed. The comparisons are counted, so a join takes O(n) time, to the end or not.

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/arrays/Interval.h>
#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_lists.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Some_positions.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Step_budget.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/input/Scene.h>
#include <CGAL/Thick_intersection_d/internal/input/coordinates.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>
#include <CGAL/Thick_intersection_d/internal/machine/rarely_called.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether joins take all points of a type that differ: those whose coordinates are doubles, in the
// plane or in space.
template <class Point>
inline constexpr bool are_joined_v
  = is_held_by_double_v<Coordinate_t<Point>>
    && (dimension_or<Point>(0) == 2 || dimension_or<Point>(0) == 3);

// Returns the length of the cells of a join, for `size` points of the scene. If the points are
// uniform, few pairs are in a common cell. Cells are long enough for points to enter few of them.
// They are not so long that one cell would hold a cluster, or many pairs of a cluster of all
// points.
CGAL_THICK_INTERSECTION_D_RARELY_CALLED
inline double join_cell_side(const Scene& scene, std::size_t size, double distance)
{
  const double dimension = scene.dimension();
  double volume = 1 / (cells_per_point * static_cast<double>(size)); // in cubes of the distance
  for(const Interval& interval : scene.box)
    volume *= (std::max)(interval.high / distance - interval.low / distance, max_cell_side);
  const double longest = std::pow(static_cast<double>(size) / points_of_long_cells, 1 / dimension);
  const double side = (std::min)(std::pow(volume, 1 / dimension), longest);
  return distance * (std::min)((std::max)(side, min_cell_side), max_cell_side);
}

// Returns after how many steps to give up a join of so many points.
inline std::size_t max_join_steps(std::size_t size)
{
  return (std::max)(max_steps_per_point * size, max_steps_of_few_points);
}

// Returns how many lists the entries of `size` points are distributed over: a power of two.
template <class ConcurrencyTag>
std::size_t cell_list_count(std::size_t size)
{
  std::size_t count = 1;
  while(size / count > entries_per_list && count < max_list_count)
    count *= 2;
  if constexpr(is_parallel_v<ConcurrencyTag>) // enough for all threads
    while(size / count > min_entries_per_list && count < block_count<ConcurrencyTag>())
      count *= 2;
  return count;
}

template <class ConcurrencyTag, int Dimension, class Elements>
class Cell_join
{
public:
  // Joins pairs within `distance`, for which Hashed_cells::fits() must hold. The order of visits
  // depends on the seed.
  Cell_join(const Elements& points, double distance, double cell_side, std::uint64_t seed)
    : points_(points),
      cells_(std::nextafter(distance / 2, std::numeric_limits<double>::infinity()),
             cell_side, seed)
  {}

  // Enters the points of a sample, and visits pairs of these points. Each task makes a visitor of
  // its own by make_visitor(). visitor(i, j) returns whether to go on. Each point is two steps of
  // progress: to enter it, and to visit its pairs. Returns false if the join was given up after
  // `max_steps` comparisons of entries.
  template <class Make_visitor, class Progress>
  bool operator()(const Some_positions& sample, std::size_t max_steps,
                  const Make_visitor& make_visitor, Progress& progress) const
  {
    const std::size_t list_count = cell_list_count<ConcurrencyTag>(sample.size());
    const Lists lists(sample.size(), list_count,
                      [&](std::size_t first, std::size_t last, const auto& append) {
                        enter(sample, first, last, list_count, append, progress);
                      });

    Step_budget budget(max_steps);
    std::atomic<bool> go_on = !progress.is_cancelled();
    for_each_block<ConcurrencyTag>(list_count, [&](std::size_t first, std::size_t last) {
      auto visitor = make_visitor();
      Bucket_table table;
      Step_counter counter(budget);
      for(std::size_t list = first; list != last && go_on.load(std::memory_order_relaxed); ++list)
        if(!join(lists, list, table, counter, visitor)
           || !progress.advance(sample.size() * (list + 1) / list_count
                                - sample.size() * list / list_count))
          go_on.store(false, std::memory_order_relaxed);
    });
    return !budget.is_exceeded();
  }

private:
  static constexpr std::size_t batch_size = 512;

  using Lists = Cell_lists<std::conditional_t<is_parallel_v<ConcurrencyTag>, Parallel_tag,
                                              Sequential_tag>>;

  // Appends the entries of the points [first, last) of the sample. Most of them have one cell. So
  // the first cells of a batch of points come first, without branches, and then the other cells.
  template <class Append_to_list, class Progress>
  void enter(const Some_positions& sample, std::size_t first, std::size_t last,
             std::size_t list_count, const Append_to_list& append_to_list,
             Progress& progress) const
  {
    const auto append = [&](std::uint64_t hash, Place position) {
      const std::uint64_t bits = (hash >> 32) * list_count; // the list, and 32 bits below it
      append_to_list(bits >> 32, {static_cast<std::uint32_t>(bits), position});
    };
    std::array<Place, batch_size> positions;
    std::array<std::uint64_t, batch_size> hashes;
    std::array<std::uint32_t, batch_size> several; // points that are in several cells
    for(; first < last; first += batch_size) {
      const std::size_t size = (std::min)(batch_size, last - first);
      sample.copy(first, first + size, positions.data());
      std::size_t several_count = 0;
      for(std::size_t i = 0; i < size; ++i) {
        const auto [hash, is_in_several] = cells_.first_cell_around(points_[positions[i]]);
        hashes[i] = hash;
        several[several_count] = static_cast<std::uint32_t>(i);
        several_count += is_in_several;
      }
      for(std::size_t i = 0; i < size; ++i)
        append(hashes[i], positions[i]);
      for(std::size_t k = 0; k < several_count; ++k)
        append_other_cells(positions[several[k]], append);
      if(!progress.advance(size))
        return;
    }
  }

  template <class Append>
  void append_other_cells(Place position, const Append& append) const
  {
    bool is_first = true;
    cells_.for_each_cell_around(points_[position], [&](std::uint64_t hash) {
      if(!is_first)
        append(hash, position);
      is_first = false;
    });
  }

  // A hash table of the entries of a list, by their cells.
  struct Bucket_table
  {
    struct Link
    {
      Cell_entry entry;
      std::uint32_t next;
    };
    std::vector<std::uint32_t> heads; // 1 + the index of a link, or 0
    Buffer<Link> links;
  };

  // Visits the pairs of a list that are in a common cell. Returns false iff the visitor stops, or
  // no steps are left.
  template <class Visitor>
  static bool join(const Lists& lists, std::size_t list, Bucket_table& table,
                   Step_counter& counter, Visitor& visitor)
  {
    const std::size_t size = lists.size(list);
    const std::uint64_t slot_count = std::uint64_t(1) << hash_table_bits(size);
    table.heads.assign(slot_count, 0);
    std::uint32_t* const heads = table.heads.data();
    typename Bucket_table::Link* const links = table.links.require(size);
    std::uint32_t count = 0;

    return lists.for_each(list, [&](const Cell_entry& entry) {
      std::uint32_t& head = heads[entry.cell * slot_count >> 32];
      for(std::uint32_t other = head; other != 0; other = links[other - 1].next)
        if(!counter.step()
           || (links[other - 1].entry.cell == entry.cell
               && !visitor(links[other - 1].entry.position, entry.position)))
          return false;
      links[count] = {entry, head};
      head = ++count;
      return true;
    });
  }

  const Elements& points_;
  const Hashed_cells<Dimension> cells_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H
