// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H

// Visits all pairs of points within a distance, and few others as long as few points have a
// neighbour so near: the fast way to the closest pair and to a close one, in the plane and in
// space.
//
// It is the grid of [L] with points put into more than one bucket instead of buckets compared with
// their neighbours. Every point enters the cells that its cube of half the distance meets; the
// cubes of two points within the distance meet, hence both are in a common cell. Cells are much
// larger than the distance, so most points enter one only. Entries are distributed over lists by a
// digit of the hash of their cell, as in radix sort; a list fits in the cache, and a hash table
// finds the cells in it. No coordinate is moved, and only points in a common cell are looked at
// again.

#include <CGAL/Thick_intersection_d/internal/closest_pair/Hashed_cells.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// The positions 0, 1, ..., size - 1, without a list of them.
class All_positions
{
public:
  explicit All_positions(std::size_t size) : size_(size) {}
  std::size_t size() const { return size_; }
  std::uint32_t operator[](std::size_t i) const { return static_cast<std::uint32_t>(i); }

private:
  std::size_t size_;
};

// A point in a cell, which is known by bits of its hash.
struct Cell_entry
{
  std::uint32_t cell;
  std::uint32_t position;
};

// Lists of entries that grow by blocks of a page.
class Cell_entry_lists
{
public:
  static constexpr std::size_t block_size = 4096 / sizeof(Cell_entry);
  using Block = std::unique_ptr<Cell_entry[]>;

  explicit Cell_entry_lists(std::size_t list_count = 0) : lists_(list_count) {}

  void append(std::size_t list, const Cell_entry& entry)
  {
    List& l = lists_[list];
    if(l.next == l.end) {
      l.blocks.emplace_back(new Cell_entry[block_size]); // not cleared
      l.next = l.blocks.back().get();
      l.end = l.next + block_size;
    }
    *l.next++ = entry;
  }

  std::size_t size(std::size_t list) const
  {
    const List& l = lists_[list];
    return l.blocks.size() * block_size - static_cast<std::size_t>(l.end - l.next);
  }

  // Calls f(entry) for the entries of a list in order, until it returns false. Returns whether it
  // never did.
  template <class Function>
  bool for_each(std::size_t list, const Function& f) const
  {
    const List& l = lists_[list];
    for(const Block& block : l.blocks) {
      const bool is_last = &block == &l.blocks.back();
      const Cell_entry* const end = is_last ? l.next : block.get() + block_size;
      for(const Cell_entry* entry = block.get(); entry != end; ++entry)
        if(!f(*entry))
          return false;
    }
    return true;
  }

private:
  struct List
  {
    Cell_entry* next = nullptr; // in the last block
    Cell_entry* end = nullptr;
    std::vector<Block> blocks;
  };

  std::vector<List> lists_;
};

template <class ConcurrencyTag, int Dimension, class Elements>
class Cell_join
{
public:
  // For pairs within `distance`, which fits Grid_cells.
  Cell_join(const Elements& points, double distance, double cell_side)
    : points_(points), cells_(Dimension, distance / 2, cell_side)
  {}

  // Enters the points at `positions`, and visits pairs of them. Each task has a visitor of its own,
  // made by make_visitor(): visitor(i, j) returns whether to go on, visitor.finish() is called
  // last. The progress is that of twice as many objects: points to enter, and points to visit.
  template <class Positions, class Make_visitor, class Progress>
  void operator()(const Positions& positions, const Make_visitor& make_visitor,
                  Progress& progress) const
  {
    int digit_bits = 0;
    while(positions.size() >> digit_bits > points_per_list && digit_bits < greatest_digit_bits)
      ++digit_bits;
    const std::size_t list_count = std::size_t(1) << digit_bits;
    const std::size_t part_count = is_parallel_v<ConcurrencyTag> ? greatest_part_count : 1;
    std::vector<Cell_entry_lists> parts(part_count);
    for_each_block<ConcurrencyTag>(part_count, [&](std::size_t first, std::size_t last) {
      for(std::size_t p = first; p != last; ++p) {
        parts[p] = Cell_entry_lists(list_count);
        enter(positions, positions.size() * p / part_count,
              positions.size() * (p + 1) / part_count, digit_bits, parts[p], progress);
      }
    });

    std::atomic<bool> go_on = !progress.is_cancelled();
    for_each_block<ConcurrencyTag>(list_count, [&](std::size_t first, std::size_t last) {
      auto visitor = make_visitor();
      Bucket_table table;
      for(std::size_t list = first; list != last && go_on.load(std::memory_order_relaxed); ++list)
        if(!join(parts, list, table, visitor)
           || !progress.advance(positions.size() * (list + 1) / list_count
                                - positions.size() * list / list_count))
          go_on.store(false, std::memory_order_relaxed);
      visitor.finish();
    });
  }

private:
  static constexpr std::size_t points_per_list = 4096;
  static constexpr int greatest_digit_bits = 11;
  static constexpr std::size_t greatest_part_count = 16;
  static constexpr std::size_t block_size = 512;

  // Appends the entries of the positions [first, last). Most points have one cell, so a block of
  // them is looked at without branches before the others.
  template <class Positions, class Progress>
  void enter(const Positions& positions, std::size_t first, std::size_t last, int digit_bits,
             Cell_entry_lists& lists, Progress& progress) const
  {
    const auto append = [&](std::uint64_t hash, std::uint32_t position) {
      const std::uint32_t cell = static_cast<std::uint32_t>(hash);
      lists.append(cell & ((std::uint32_t(1) << digit_bits) - 1), {cell >> digit_bits, position});
    };
    std::array<std::uint64_t, block_size> hashes;
    std::array<std::uint32_t, block_size> several; // those that are in several cells
    for(; first < last; first += block_size) {
      const std::size_t size = (std::min)(block_size, last - first);
      std::size_t several_count = 0;
      for(std::size_t i = 0; i < size; ++i) {
        const auto [hash, is_in_several] = cells_.first_cell_around(points_[positions[first + i]]);
        hashes[i] = hash;
        several[several_count] = static_cast<std::uint32_t>(i);
        several_count += is_in_several;
      }
      for(std::size_t i = 0; i < size; ++i)
        append(hashes[i], positions[first + i]);
      for(std::size_t k = 0; k < several_count; ++k) {
        const std::uint32_t position = positions[first + several[k]];
        bool is_first = true;
        cells_.for_each_cell_around(points_[position], [&](std::uint64_t hash) {
          if(!is_first)
            append(hash, position);
          is_first = false;
        });
      }
      if(!progress.advance(size))
        return;
    }
  }

  // The entries of a list by the hash of their cell.
  struct Bucket_table
  {
    struct Link
    {
      Cell_entry entry;
      std::uint32_t next;
    };
    std::vector<std::uint32_t> heads; // 1 + a link, or 0
    std::vector<Link> links;
  };

  // Visits the pairs of a list that are in a common cell; returns false iff the visitor said so.
  template <class Visitor>
  static bool join(const std::vector<Cell_entry_lists>& parts, std::size_t list,
                   Bucket_table& table, Visitor& visitor)
  {
    std::size_t size = 0;
    for(const Cell_entry_lists& part : parts)
      size += part.size(list);
    std::size_t slot_count = 16;
    while(slot_count < 2 * size)
      slot_count *= 2;
    table.heads.assign(slot_count, 0);
    table.links.resize(size);
    std::uint32_t* const heads = table.heads.data();
    typename Bucket_table::Link* const links = table.links.data();
    std::uint32_t count = 0;

    const auto visit_and_add = [&](const Cell_entry& entry) {
      std::uint32_t& head = heads[entry.cell & (slot_count - 1)];
      for(std::uint32_t other = head; other != 0; other = links[other - 1].next)
        if(links[other - 1].entry.cell == entry.cell
           && !visitor(links[other - 1].entry.position, entry.position))
          return false;
      links[count] = {entry, head};
      head = ++count;
      return true;
    };
    for(const Cell_entry_lists& part : parts)
      if(!part.for_each(list, visit_and_add))
        return false;
    return true;
  }

  const Elements& points_;
  const Grid_cells<Dimension> cells_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_JOIN_H
