// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H

// The entries of a join of cells, distributed over lists by their hashes. In sequence, the lists
// grow as the entries come. In parallel, each block of points has a part of every list: it writes
// its entries down, counts them, and puts them in the order of lists, while they are in a cache.
// Growing lists of each thread would take a chunk of memory for each list and thread.

#include <CGAL/Thick_intersection_d/internal/arrays/Chunked_lists.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A point in a cell. Bits of its hash identify the cell: those below the bits of its list.
struct Cell_entry
{
  std::uint32_t cell;
  Place position;
};

class Cell_lists
{
  struct Entry_of_list
  {
    Cell_entry entry;
    std::uint32_t list;
  };
  using Growing_lists = Chunked_lists<Cell_entry, 4096 / sizeof(Cell_entry)>; // chunks of a page

public:
  // Appends entries to the lists, in sequence.
  struct Appender
  {
    std::size_t list_count;
    Growing_lists& lists;

    void append(std::uint64_t hash, Place position)
    {
      const std::uint64_t bits = (hash >> 32) * list_count; // the list, and 32 bits below it
      lists.append(bits >> 32, {static_cast<std::uint32_t>(bits), position});
    }
  };

  // Writes down the entries of a block of points and counts them by list, in parallel.
  struct Writer
  {
    std::size_t list_count;
    std::uint32_t* counts;
    std::vector<Entry_of_list> entries;

    void append(std::uint64_t hash, Place position)
    {
      const std::uint64_t bits = (hash >> 32) * list_count;
      const auto list = static_cast<std::uint32_t>(bits >> 32);
      entries.push_back({{static_cast<std::uint32_t>(bits), position}, list});
      ++counts[list];
    }
  };

  // Makes lists for the entries of `size` points. enter(first, last, writer) gives the entries of
  // the points [first, last) to an Appender or a Writer.
  template <class Enter>
  Cell_lists(std::size_t size, const Threads& threads, const Enter& enter)
    : count_(list_count(size, threads)), lists_(count_)
  {
    if(threads.are_many())
      enter_in_blocks(size, threads, enter);
    else {
      Appender appender = {count_, lists_};
      enter(std::size_t(0), size, appender);
    }
  }

  // The number of lists.
  std::size_t count() const { return count_; }

  // The number of entries in a list.
  std::size_t size(std::size_t list) const
  {
    std::size_t size = lists_.size(list);
    for(const Block& block : blocks_)
      size += static_cast<std::size_t>(block.end(list) - block.begin(list));
    return size;
  }

  // Calls task(first, last) for the entries of a list, in runs that lie in order, until the task
  // returns false. Returns whether the task never returned false.
  template <class Task>
  bool for_each_run(std::size_t list, const Task& task) const
  {
    return lists_.for_each_chunk(list, task)
           && std::all_of(blocks_.begin(), blocks_.end(), [&](const Block& block) {
                return task(block.begin(list), block.end(list));
              });
  }

private:
  // Returns how many lists the entries of `size` points are distributed over: a power of two.
  static std::size_t list_count(std::size_t size, const Threads& threads)
  {
    std::size_t count = 1;
    while(size / count > entries_per_list && count < max_list_count)
      count *= 2;
    if(threads.are_many()) // enough for all threads
      while(size / count > min_entries_per_list && count < threads.block_count())
        count *= 2;
    return count;
  }

  // The entries of a block of points, list after list.
  struct Block
  {
    std::unique_ptr<Cell_entry[]> entries;
    const std::uint32_t* ends; // of the lists

    const Cell_entry* begin(std::size_t list) const
    {
      return entries.get() + (list == 0 ? 0 : ends[list - 1]);
    }
    const Cell_entry* end(std::size_t list) const { return entries.get() + ends[list]; }
  };

  template <class Enter>
  void enter_in_blocks(std::size_t size, const Threads& threads, const Enter& enter)
  {
    blocks_.resize((std::min)((std::max)(threads.block_count(), size / max_entry_block_size + 1),
                              size / min_entry_block_size + 1));
    ends_ = make_uninitialized<std::uint32_t>(blocks_.size() * count_);
    threads.run_blocks(blocks_.size(), [&](std::size_t block, std::size_t last) {
      Writer writer = {count_, nullptr, {}};
      for(; block != last; ++block) {
        const std::size_t begin = block * size / blocks_.size();
        const std::size_t end = (block + 1) * size / blocks_.size();
        writer.counts = ends_.get() + block * count_;
        std::fill_n(writer.counts, count_, 0);
        writer.entries.clear();
        writer.entries.reserve((end - begin) + (end - begin) / 4); // some are in several cells
        enter(begin, end, writer);
        blocks_[block] = put_in_order(writer);
      }
    });
  }

  static Block put_in_order(const Writer& writer)
  {
    std::uint32_t* const next = writer.counts;
    replace_by_prefix_sums(next, next + writer.list_count);
    Block block = {make_uninitialized<Cell_entry>(writer.entries.size()), next};
    for(const Entry_of_list& e : writer.entries)
      block.entries[next[e.list]++] = e.entry;
    return block;
  }

  const std::size_t count_;
  Growing_lists lists_;       // in sequence
  std::vector<Block> blocks_; // in parallel
  std::unique_ptr<std::uint32_t[]> ends_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
