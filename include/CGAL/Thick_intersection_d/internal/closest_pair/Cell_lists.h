// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H

// The entries of a join of cells, distributed over lists by their hashes. In sequence, the lists
// grow as the entries come. In parallel, blocks of points write down and count their entries at the
// same time, and then move them to the lists: lists of each thread would take a chunk of memory for
// each list and thread, and all threads would wait until it is freed.

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
  // Takes the entries of a block of points.
  struct Writer
  {
    std::size_t list_count;
    Growing_lists* lists;               // in sequence
    std::vector<Entry_of_list> entries; // in parallel
    std::size_t* counts;                // of these, by list

    void append(std::uint64_t hash, Place position)
    {
      const std::uint64_t bits = (hash >> 32) * list_count; // the list, and 32 bits below it
      const Cell_entry entry = {static_cast<std::uint32_t>(bits), position};
      if(lists != nullptr)
        lists->append(bits >> 32, entry);
      else {
        entries.push_back({entry, static_cast<std::uint32_t>(bits >> 32)});
        ++counts[bits >> 32];
      }
    }
  };

  // Makes lists for the entries of `size` points. enter(first, last, writer) appends the entries of
  // the points [first, last).
  template <class Enter>
  Cell_lists(std::size_t size, const Threads& threads, const Enter& enter)
    : begins_(list_count(size, threads) + 1, 0), lists_(threads.are_many() ? 0 : count())
  {
    if(threads.are_many())
      enter_in_blocks(size, threads, enter);
    else {
      Writer writer = {count(), &lists_, {}, nullptr};
      enter(std::size_t(0), size, writer);
    }
  }

  // The number of lists.
  std::size_t count() const { return begins_.size() - 1; }

  // The number of entries in a list.
  std::size_t size(std::size_t list) const
  {
    return entries_ ? begins_[list + 1] - begins_[list] : lists_.size(list);
  }

  // Calls task(first, last) for the entries of a list, in runs that lie in order, until the task
  // returns false. Returns whether the task never returned false.
  template <class Task>
  bool for_each_run(std::size_t list, const Task& task) const
  {
    if(entries_)
      return task(entries_.get() + begins_[list], entries_.get() + begins_[list + 1]);
    return lists_.for_each_chunk(list, task);
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

  template <class Enter>
  void enter_in_blocks(std::size_t size, const Threads& threads, const Enter& enter)
  {
    std::vector<Writer> blocks(
      (std::min)(threads.block_count(), size / min_entry_block_size + 1));
    const auto next = make_uninitialized<std::size_t>(blocks.size() * count());
    threads.run_numbered_blocks(
      blocks.size(), size, [&](std::size_t block, std::size_t first, std::size_t last) {
        Writer& writer = blocks[block] = {count(), nullptr, {}, next.get() + block * count()};
        std::fill_n(writer.counts, count(), std::size_t(0));
        writer.entries.reserve((last - first) + (last - first) / 4); // some are in several cells
        enter(first, last, writer);
      });
    replace_by_sums_over_blocks(threads, next.get(), blocks.size(), count(), begins_.data());
    replace_by_prefix_sums(begins_.data(), begins_.data() + begins_.size());
    entries_ = make_uninitialized<Cell_entry>(begins_.back());
    threads.run_blocks(blocks.size(), [&](std::size_t block, std::size_t end) {
      for(; block != end; ++block) {
        std::size_t* const places = blocks[block].counts;
        add_begins(places, begins_.data(), count());
        for(const Entry_of_list& e : blocks[block].entries)
          entries_[places[e.list]++] = e.entry;
        blocks[block].entries = {}; // frees its memory
      }
    });
  }

  std::vector<std::size_t> begins_; // of the lists, in parallel
  std::unique_ptr<Cell_entry[]> entries_; // in parallel
  Growing_lists lists_;                   // in sequence
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
