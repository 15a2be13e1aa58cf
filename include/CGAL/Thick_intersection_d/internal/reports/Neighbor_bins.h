// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_BINS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_BINS_H

// Neighbours in any order, thrown into bins by one thread: a bin for as many consecutive points as
// have their lists in a cache.

#include <CGAL/Neighbor_lists.h>
#include <CGAL/Thick_intersection_d/internal/arrays/uninitialized_memory.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Bins grow by chunks that stay where they are; vectors would copy all neighbours to grow. Chunks
// are taken from large blocks of memory, which copies of the bins share.
class Neighbor_bins
{
public:
  using Position = Neighbor_lists::Position;
  static constexpr std::size_t bin_size = 16384; // points

  // Makes bins for `size` points.
  explicit Neighbor_bins(std::size_t size) : bins_((size + bin_size - 1) / bin_size) {}

  // Throws the neighbour of a point into the bin of that.
  void add(Position of, Position neighbor)
  {
    Bin& bin = bins_[of / bin_size];
    if(bin.next == bin.end)
      extend(bin);
    *bin.next++ = {static_cast<std::uint16_t>(of % bin_size), static_cast<std::uint16_t>(neighbor),
                   static_cast<std::uint16_t>(neighbor >> 16)};
  }

  // Returns the number of neighbours in a bin.
  std::size_t size(std::size_t index) const
  {
    const Bin& bin = bins_[index];
    return bin.chunks.size() * chunk_size - static_cast<std::size_t>(bin.end - bin.next);
  }

  // Calls task(of, neighbor) for those in a bin, where `of` is counted from its first point.
  template <class Task>
  void for_each(std::size_t index, const Task& task) const
  {
    const Bin& bin = bins_[index];
    for(const Neighbor* chunk : bin.chunks) {
      const Neighbor* const end = chunk + chunk_size == bin.end ? bin.next : chunk + chunk_size;
      for(; chunk != end; ++chunk)
        task(chunk->of, chunk->low | static_cast<Position>(chunk->high) << 16);
    }
  }

private:
  static constexpr std::size_t chunk_size = 1024;     // neighbours
  static constexpr std::size_t greatest_block = 2048; // chunks

  // Six bytes: much of the time goes into moving them.
  struct Neighbor
  {
    std::uint16_t of;
    std::uint16_t low;
    std::uint16_t high;
  };

  struct Bin
  {
    std::vector<Neighbor*> chunks;
    Neighbor* next = nullptr; // in the last chunk
    Neighbor* end = nullptr;  // of it
  };

  void extend(Bin& bin)
  {
    if(chunks_left_ == 0) {
      block_size_ = (std::min)(2 * block_size_, greatest_block);
      chunks_left_ = block_size_;
      blocks_.emplace_back(make_uninitialized<Neighbor>(block_size_ * chunk_size));
    }
    bin.next = blocks_.back().get() + --chunks_left_ * chunk_size;
    bin.end = bin.next + chunk_size;
    bin.chunks.push_back(bin.next);
  }

  std::vector<Bin> bins_;
  std::vector<std::shared_ptr<Neighbor[]>> blocks_;
  std::size_t block_size_ = 1; // of the last block, in chunks
  std::size_t chunks_left_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_REPORTS_NEIGHBOR_BINS_H
