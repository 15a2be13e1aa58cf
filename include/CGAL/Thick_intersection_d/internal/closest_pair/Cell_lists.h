// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H

// The entries of a join of cells, distributed over lists by their hashes. In sequence, the lists
// grow as the entries come. In parallel, each block of points has a part of every list: it writes
// its entries down, counts them, and puts them in the order of lists, while they are in a cache.
// Growing lists of each thread would take a chunk of memory for each list and thread. All blocks
// have one array, because its pages are huge.

#include <CGAL/Thick_intersection_d/internal/arrays/Chunked_lists.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
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
    void append(const std::uint64_t* hashes, const Place* positions, std::size_t size)
    {
      for(std::size_t i = 0; i < size; ++i)
        append(hashes[i], positions[i]);
    }
  };

  // Writes down the entries of a block of points and counts them by list, in parallel. They keep
  // the bits of their lists until they are put in order.
  class Writer
  {
  public:
    // There are counts of all lists, which are 0, and room for so many entries at first.
    Writer(std::size_t list_count, std::uint32_t* counts, std::size_t room)
      : list_count_(list_count), counts_(counts), room_(room),
        entries_(make_uninitialized<Cell_entry>(room))
    {}

    void append(std::uint64_t hash, Place position) { append(&hash, &position, 1); }
    void append(const std::uint64_t* hashes, const Place* positions, std::size_t size)
    {
      if(room_ - size_ < size)
        make_room(size);
      Cell_entry* const first = entries_.get() + size_;
      for(std::size_t i = 0; i < size; ++i) {
        first[i] = {static_cast<std::uint32_t>(hashes[i] >> 32), positions[i]};
        ++counts_[(hashes[i] >> 32) * list_count_ >> 32];
      }
      size_ += size;
    }

    std::size_t size() const { return size_; }

    // Writes the entries of the block in the order of their lists, and turns the counts into ends.
    void put_in_order(Cell_entry* result) const
    {
      // Lists would wait for these lines one after another.
      for(std::size_t line = 0; line <= size_ * sizeof(Cell_entry) / cache_line_size; ++line)
        prefetch_to_write(result, line);
      std::uint32_t* const next = counts_;
      replace_by_prefix_sums(next, next + list_count_);
      for(std::size_t i = 0; i < size_; ++i) {
        const Cell_entry e = entries_[i];
        const std::uint64_t bits = e.cell * std::uint64_t(list_count_);
        result[next[bits >> 32]++] = {static_cast<std::uint32_t>(bits), e.position};
      }
    }

  private:
    CGAL_THICK_INTERSECTION_D_RARELY_CALLED void make_room(std::size_t more)
    {
      room_ = 2 * size_ + more;
      std::unique_ptr<Cell_entry[]> entries = make_uninitialized<Cell_entry>(room_);
      std::copy_n(entries_.get(), size_, entries.get());
      entries_ = std::move(entries);
    }

    const std::size_t list_count_;
    std::uint32_t* const counts_;
    std::size_t room_;
    std::unique_ptr<Cell_entry[]> entries_;
    std::size_t size_ = 0;
  };

  // Makes lists for the entries of `size` points. enter(first, last, writer) gives the entries of
  // the points [first, last) to an Appender or a Writer. About so many per point are expected.
  template <class Enter>
  Cell_lists(std::size_t size, double entries_per_point, const Threads& threads,
             const Enter& enter)
    : count_(list_count(size, threads)), lists_(count_)
  {
    if(threads.are_many())
      enter_in_blocks(size, entries_per_point, threads, enter);
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
    Cell_entry* entries;
    std::uint32_t* ends; // of the lists
    std::unique_ptr<Cell_entry[]> own_memory; // if there are more than expected

    const Cell_entry* begin(std::size_t list) const
    {
      return entries + (list == 0 ? 0 : ends[list - 1]);
    }
    const Cell_entry* end(std::size_t list) const { return entries + ends[list]; }
  };

  template <class Enter>
  void enter_in_blocks(std::size_t size, double entries_per_point, const Threads& threads,
                       const Enter& enter)
  {
    const std::size_t block_count = entry_block_count(size, threads);
    const auto room = static_cast<std::size_t>(static_cast<double>(size / block_count + 1)
                                               * entries_per_point * entry_room) + min_entry_room;
    entries_ = make_uninitialized<Cell_entry>(block_count * room);
    ends_ = make_uninitialized<std::uint32_t>(block_count * count_);
    blocks_.resize(block_count);
    threads.run_numbered_blocks(
      block_count, size, [&](std::size_t index, std::size_t first, std::size_t last) {
        Block& block = blocks_[index];
        block.ends = ends_.get() + index * count_;
        std::fill_n(block.ends, count_, 0);
        Writer writer(count_, block.ends, room);
        enter(first, last, writer);
        block.entries = entries_.get() + index * room;
        if(writer.size() > room) {
          block.own_memory = make_uninitialized<Cell_entry>(writer.size());
          block.entries = block.own_memory.get();
        }
        writer.put_in_order(block.entries);
      });
  }

  // Returns how many blocks `size` points are entered in: half as many as threads usually take,
  // because a list is read in as many runs.
  static std::size_t entry_block_count(std::size_t size, const Threads& threads)
  {
    return (std::min)((std::max)(threads.block_count() / 2, size / max_entry_block_size + 1),
                      size / min_entry_block_size + 1);
  }

  const std::size_t count_;
  Growing_lists lists_;       // in sequence
  std::vector<Block> blocks_; // in parallel
  std::unique_ptr<Cell_entry[]> entries_;
  std::unique_ptr<std::uint32_t[]> ends_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
