// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H

// The entries of a join of cells, distributed over lists. In sequence, the lists grow as the
// entries come. In parallel, blocks of points write down and count their entries at the same time,
// and then move them to the lists: lists of each thread would take a chunk of memory for each list
// and thread, and all threads would wait until it is freed.

#include <CGAL/Thick_intersection_d/internal/arrays/Chunked_lists.h>
#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/prefix_sums.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/closest_pair/tuning.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

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

template <class ConcurrencyTag>
class Cell_lists
{
public:
  // Makes lists for the entries of `size` points. enter(first, last, append) calls append(list,
  // entry) for the entries of the points [first, last).
  template <class Enter>
  Cell_lists(std::size_t size, std::size_t list_count, const Enter& enter) : lists_(list_count)
  {
    enter(std::size_t(0), size, [&](std::size_t list, const Cell_entry& entry) {
      lists_.append(list, entry);
    });
  }

  // The number of entries in a list.
  std::size_t size(std::size_t list) const { return lists_.size(list); }

  // Calls task(entry) for the entries of a list, until the task returns false. Returns whether the
  // task never returned false.
  template <class Task>
  bool for_each(std::size_t list, const Task& task) const
  {
    return lists_.for_each(list, task);
  }

private:
  Chunked_lists<Cell_entry, 4096 / sizeof(Cell_entry)> lists_; // in chunks of a page
};

template <>
class Cell_lists<Parallel_tag>
{
public:
  template <class Enter>
  Cell_lists(std::size_t size, std::size_t list_count, const Enter& enter)
    : begins_(list_count + 1, 0)
  {
    const std::size_t block_count
      = (std::min)(internal::block_count<Parallel_tag>(), size / min_entry_block_size + 1);
    std::vector<std::vector<Entry_of_list>> blocks(block_count);
    const auto next = make_uninitialized<std::size_t>(block_count * list_count);
    for_each_numbered_block<Parallel_tag>(
      block_count, size, [&](std::size_t block, std::size_t first, std::size_t last) {
        std::size_t* const counts = next.get() + block * list_count;
        std::fill_n(counts, list_count, std::size_t(0));
        std::vector<Entry_of_list>& entries = blocks[block];
        entries.reserve((last - first) + (last - first) / 4); // some are in several cells
        enter(first, last, [&](std::size_t list, const Cell_entry& entry) {
          entries.push_back({entry, static_cast<std::uint32_t>(list)});
          ++counts[list];
        });
      });
    replace_by_sums_over_blocks(Threads(Parallel_tag()), next.get(), block_count, list_count,
                                begins_.data());
    replace_by_prefix_sums(begins_.data(), begins_.data() + begins_.size());
    entries_ = make_uninitialized<Cell_entry>(begins_.back());
    for_each_block<Parallel_tag>(block_count, [&](std::size_t block, std::size_t end) {
      for(; block != end; ++block) {
        std::size_t* const places = next.get() + block * list_count;
        add_begins(places, begins_.data(), list_count);
        for(const Entry_of_list& e : blocks[block])
          entries_[places[e.list]++] = e.entry;
        blocks[block] = {}; // frees its memory
      }
    });
  }

  std::size_t size(std::size_t list) const { return begins_[list + 1] - begins_[list]; }

  template <class Task>
  bool for_each(std::size_t list, const Task& task) const
  {
    const Cell_entry* const end = entries_.get() + begins_[list + 1];
    for(const Cell_entry* entry = entries_.get() + begins_[list]; entry != end; ++entry)
      if(!task(*entry))
        return false;
    return true;
  }

private:
  struct Entry_of_list
  {
    Cell_entry entry;
    std::uint32_t list;
  };

  std::vector<std::size_t> begins_; // of the lists
  std::unique_ptr<Cell_entry[]> entries_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_CELL_LISTS_H
