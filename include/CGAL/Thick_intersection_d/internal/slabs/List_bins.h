// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_BINS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_BINS_H

// The complete lists that one thread makes, of points in any order, in bins. A bin takes the lists
// of consecutive points, so few that a cache holds their lists.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class List_bins
{
public:
  // The number of points of a bin. 8192 points with 20 neighbors each have lists of 0.7 MB.
  static constexpr std::size_t bin_size = 8192;

  // Whether the neighbors of a point come in ascending order.
  static constexpr bool are_sorted = true;

  // A short list has no more neighbors.
  static constexpr std::size_t max_short_size = 32;

  // Makes bins for `size` points.
  explicit List_bins(std::size_t size) : bins_((size + bin_size - 1) / bin_size) {}

  // A copy has as many bins, which are empty.
  List_bins(const List_bins& other) : bins_(other.bins_.size()) {}
  List_bins& operator=(const List_bins&) = delete;

  // Returns the number of neighbors in a bin.
  std::size_t size(std::size_t bin) const { return bins_[bin].size; }

  // Appends a short list to the bin of the point `of`. Returns where to write its neighbors. There
  // is room for `max_short_size` of them, which the next list writes over.
  Place* append_short(Place of, std::size_t size)
  {
    Bin& bin = bins_[of / bin_size];
    if(bin.end - bin.next < static_cast<std::ptrdiff_t>(1 + max_short_size))
      extend(bin);
    Place* const list = append_part(bin, of, size);
    // Each list goes to another bin, so the processor cannot guess where the next ones go.
    prefetch_to_write(bin.next, 1);
    prefetch_to_write(bin.next, 2);
    return list;
  }

  // Appends a list of any size to the bin of the point `of`, in parts.
  void append(Place of, const Place* first, const Place* last)
  {
    Bin& bin = bins_[of / bin_size];
    while(first != last) {
      if(bin.end - bin.next < 2)
        extend(bin);
      const std::ptrdiff_t size = (std::min)(last - first, bin.end - bin.next - 1);
      std::copy_n(first, size, append_part(bin, of, static_cast<std::size_t>(size)));
      first += size;
    }
  }

  // Calls task(of, first, last) for each part of a list in a bin, in the order in which they were
  // appended. `of` counts from the first point of the bin.
  template <class Task>
  void for_each(std::size_t bin, const Task& task) const
  {
    const Bin& b = bins_[bin];
    for(std::size_t c = 0; c < b.chunks.size(); ++c) {
      const Place* part = b.chunks[c].begin;
      const Place* const end = c + 1 < b.chunks.size() ? b.chunks[c].end : b.next;
      while(part != end) {
        prefetch_to_read(part, lines_ahead);
        prefetch_to_read(part, lines_ahead + 1);
        const Place* const first = part + 1;
        const Place* const last = first + *part % max_part_size;
        task(*part / max_part_size, first, last);
        part = last;
      }
    }
  }

  // Frees the memory of all lists. No list can be appended or read then.
  void clear()
  {
    bins_.clear();
    blocks_.clear();
  }

private:
  // In positions. The chunks of a bin double up to the largest size, and so do blocks.
  static constexpr std::size_t first_chunk_size = 64;
  static constexpr std::size_t doublings = 5;
  static constexpr std::size_t largest_chunk_size = first_chunk_size << doublings;
  static constexpr std::size_t max_block_size = 1024 * largest_chunk_size;
  static_assert(first_chunk_size > max_short_size);

  static constexpr std::size_t lines_ahead = 16;

  // A part begins with the number of its point in the bin times this number, plus its size.
  static constexpr Place max_part_size = 1 << 16;
  static_assert(largest_chunk_size < max_part_size && bin_size <= max_part_size);

  struct Chunk
  {
    Place* begin;
    Place* end; // of what is used, unless it is the last chunk
  };

  struct Bin
  {
    Place* next = nullptr; // in the last chunk
    Place* end = nullptr;  // of the last chunk
    std::size_t size = 0;
    std::vector<Chunk> chunks;
  };

  static Place* append_part(Bin& bin, Place of, std::size_t size)
  {
    Place* const part = bin.next;
    *part = static_cast<Place>(of % bin_size * max_part_size + size);
    bin.next += 1 + size;
    bin.size += size;
    return part + 1;
  }

  // Large blocks of memory hold many chunks, because each block costs an allocation. Chunks double:
  // one of many threads has few lists in each bin, and the memory of all must be linear in these.
  CGAL_THICK_INTERSECTION_D_RARELY_CALLED void extend(Bin& bin)
  {
    const std::size_t size = first_chunk_size << (std::min)(bin.chunks.size(), doublings);
    if(left_ < size) {
      block_size_ = (std::min)(2 * block_size_, max_block_size);
      blocks_.emplace_back(make_uninitialized<Place>(block_size_));
      left_ = block_size_;
    }
    left_ -= size;
    Place* const begin = blocks_.back().get() + left_;
    bin.chunks.push_back({begin, nullptr});
    if(bin.chunks.size() > 1)
      bin.chunks[bin.chunks.size() - 2].end = bin.next;
    bin.next = begin;
    bin.end = begin + size;
  }

  std::vector<Bin> bins_;
  std::vector<std::unique_ptr<Place[]>> blocks_;
  std::size_t block_size_ = largest_chunk_size; // of the last block
  std::size_t left_ = 0;                        // of the last block
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_LIST_BINS_H
