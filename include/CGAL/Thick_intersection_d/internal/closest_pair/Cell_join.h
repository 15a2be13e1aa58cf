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
// the taker looks again only at points in a common cell.
//
// In fixed dimension a point enters O(1) cells (Hashed_cells.h). An entry is compared with those in
// the same place of the hash table. Of these, expected O(1) are of other cells, for any points and
// a random seed. The comparisons are counted, so a join takes O(n) time, to the end or not.

#include <CGAL/Thick_intersection_d/internal/arrays/hash.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Cell_lists.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Join_task.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/Some_positions.h>
#include <CGAL/Thick_intersection_d/internal/lanes/Near_pairs.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Near_task.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Point_reader.h>

#include <boost/config.hpp> // BOOST_NOINLINE

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The comparisons of entries that all threads have made, and may make.
struct Join_steps
{
  const std::size_t most;
  std::atomic<std::size_t> made = 0;

  bool are_left() const { return made.load(std::memory_order_relaxed) <= most; }
};

// Hands on the pairs of points in a common cell.
class Cell_pairs
{
public:
  Cell_pairs(Join_steps& steps, Pair_taker& taker) : all_steps_(steps), taker_(taker) {}

  // Gives the pairs of a list to the taker. Returns false iff it stops, or no steps are left.
  BOOST_NOINLINE bool give(const Cell_lists& lists, std::size_t list)
  {
    const auto none = static_cast<std::uint32_t>(lists.size(list)); // the index of no link
    const std::uint64_t slot_count = std::uint64_t(1) << hash_table_bits(none);
    heads_.assign(slot_count, none);
    std::uint32_t* const heads = heads_.data();
    Link* const links = links_.require(none);
    std::uint32_t count = 0;
    const bool is_complete
      = lists.for_each_run(list, [&](const Cell_entry* entry, const Cell_entry* end) {
          for(; entry != end; ++entry, ++count) {
            std::uint32_t& head = heads[entry->cell * slot_count >> 32];
            if(head != none && !give_cell(*entry, links, head, none))
              return false;
            links[count] = {*entry, head};
            head = count;
          }
          return true;
        });
    return flush() && is_complete;
  }

private:
  // So few that it matters little what threads do not tell.
  static constexpr std::size_t step_batch_size = 256;

  // The entries in a slot of a hash table are linked.
  struct Link
  {
    Cell_entry entry;
    std::uint32_t next;
  };

  // Gives the pairs of an entry and the entries of its cell that are linked from `other` on. A
  // point may have two of them, if two of its cells have one hash. These are no pair.
  BOOST_NOINLINE
  bool give_cell(Cell_entry entry, const Link* links, std::uint32_t other, std::uint32_t none)
  {
    for(; other != none; other = links[other].next, ++steps_)
      if(const Cell_entry& e = links[other].entry;
         e.cell == entry.cell && e.position != entry.position) {
        *next_++ = {e.position, entry.position};
        if(next_ == pairs_.data() + pairs_.size() && !flush())
          return false;
      }
    return steps_ < step_batch_size || are_steps_left();
  }

  BOOST_NOINLINE bool are_steps_left()
  {
    all_steps_.made.fetch_add(std::exchange(steps_, 0), std::memory_order_relaxed);
    return all_steps_.are_left();
  }

  BOOST_NOINLINE bool flush()
  {
    Found_pair* const end = std::exchange(next_, pairs_.data());
    return end == next_ || taker_.take(next_, static_cast<std::size_t>(end - next_));
  }

  Join_steps& all_steps_;
  std::size_t steps_ = 0; // of this thread, since it told them to the others
  Pair_taker& taker_;
  std::vector<std::uint32_t> heads_; // by slot: the index of a link
  Buffer<Link> links_;
  std::array<Found_pair, 256> pairs_;
  Found_pair* next_ = pairs_.data(); // where the next pair goes
};

template <int Dimension>
class Cell_join
{
public:
  // Joins pairs within `distance`, for which do_cells_fit() must hold. The order of visits depends
  // on the seed.
  Cell_join(Near_points<Dimension>& points, const Join_task<Dimension>& task, double distance,
            double cell_side, std::uint64_t seed)
    : points_(points), threads_(task.threads),
      cells_(task.box, task.error,
             std::nextafter(distance / 2, std::numeric_limits<double>::infinity()), cell_side,
             seed),
      entries_per_point_(std::pow(1 + distance / cell_side, Dimension))
  {}

  // Enters the points of a sample, and gives pairs of these points to the taker. Each point is two
  // steps of progress: to enter it, and to visit its pairs. The join is given up after `max_steps`
  // comparisons of entries.
  Joined operator()(const Some_positions& sample, std::size_t max_steps, Pair_taker& taker)
  {
    const Cell_lists lists(
      sample.size(), entries_per_point_, threads_,
      [&](std::size_t first, std::size_t last, auto& writer) {
        enter(sample, first, last, writer);
      });
    Join_steps steps = {max_steps};
    threads_.run_blocks(lists.count(), [&](std::size_t first, std::size_t last) {
      Cell_pairs pairs(steps, taker);
      for(std::size_t list = first; list != last && goes_on_.load(std::memory_order_relaxed);
          ++list)
        if(!pairs.give(lists, list)
           || !points_.advance(sample.size() * (list + 1) / lists.count()
                               - sample.size() * list / lists.count()))
          goes_on_.store(false, std::memory_order_relaxed);
    });
    if(!steps.are_left())
      return Joined::GIVEN_UP;
    return goes_on_.load(std::memory_order_relaxed) ? Joined::ALL : Joined::STOPPED;
  }

private:
  static constexpr std::size_t block_size = Point_block::max_size;
  static constexpr int all_axes = Near_points<Dimension>::all_axes;

  // Appends the entries of the points [first, last) of the sample.
  template <class Writer>
  void enter(const Some_positions& sample, std::size_t first, std::size_t last, Writer& writer)
  {
    const Block_reader<Dimension> reader(points_);
    for(; first < last; first += block_size) {
      const std::size_t end = (std::min)(first + block_size, last);
      if(sample.are_first())
        reader.read_blocks(first, end, all_axes, [&](const Point_block& block) {
          enter(block, writer);
        });
      else
        enter_drawn(sample.data() + first, end - first, writer);
      if(!points_.advance(end - first)) {
        goes_on_.store(false, std::memory_order_relaxed);
        return;
      }
    }
  }

  template <class Writer>
  BOOST_NOINLINE
  void enter_drawn(const Place* positions, std::size_t size, Writer& writer) const
  {
    std::array<std::array<double, Dimension>, block_size> x;
    points_.read_at(positions, size, x[0].data());
    enter({0, size, reinterpret_cast<const char*>(x.data()), sizeof(x[0]), positions}, writer);
  }

  // Most points have one cell. So the first cells of all points come first, without branches, and
  // then the other cells.
  template <class Writer>
  BOOST_NOINLINE void enter(const Point_block& block, Writer& writer) const
  {
    std::array<std::uint64_t, block_size> hashes;
    std::array<std::uint32_t, block_size> several; // points that are in several cells
    std::size_t several_count = 0;
    const auto add = [&](std::size_t i, const First_cell& cell) {
      hashes[i] = cell.hash;
      several[several_count] = static_cast<std::uint32_t>(i);
      several_count += cell.has_others;
    };
    if(cells_.are_near())
      for(std::size_t i = 0; i < block.size; ++i)
        add(i, cells_.first_near_cell_around(block.point(i)));
    else
      for(std::size_t i = 0; i < block.size; ++i)
        add(i, cells_.first_cell_around(block.point(i)));
    writer.append(hashes.data(), block.numbers, block.size);
    for(std::size_t k = 0; k < several_count; ++k) {
      const Place position = block.numbers[several[k]];
      bool is_first = true;
      cells_.for_each_cell_around(block.point(several[k]), [&](std::uint64_t hash) {
        if(!is_first)
          writer.append(hash, position);
        is_first = false;
      });
    }
  }

  Near_points<Dimension>& points_;
  const Threads threads_;
  const Hashed_cells<Dimension> cells_;
  const double entries_per_point_; // if points lie anywhere in their cells
  std::atomic<bool> goes_on_ = true;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H
