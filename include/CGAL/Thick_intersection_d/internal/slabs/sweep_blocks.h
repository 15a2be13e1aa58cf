// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SWEEP_BLOCKS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SWEEP_BLOCKS_H

// Shares the slabs out among threads, in blocks. A thread mostly takes blocks that follow each
// other. Then it goes on with the slabs that it has ready.

#include <CGAL/Thick_intersection_d/internal/arrays/positions.h>
#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/slabs/Slabs.h>
#include <CGAL/Thick_intersection_d/internal/slabs/tuning.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// As sweep_blocks(), for the slabs [first, last). Unless it is null, `sweeper` goes on with them.
// It becomes what goes on behind them.
template <class Sweeper, class Point, class Make, class Sweep_to>
void sweep_range(const Slabs<Point>& slabs, Place first, Place last,
                 std::unique_ptr<Sweeper>& sweeper, const Make& make, const Sweep_to& sweep_to)
{
  while(first != last) {
    const Place column = first / slabs.count();
    const Place begin = column * slabs.count();
    if(sweeper == nullptr)
      sweeper = make(column, first - begin);
    first = (std::min)(last, begin + slabs.count());
    sweep_to(*sweeper, first - begin);
    if(first == begin + slabs.count())
      sweeper = nullptr;
  }
}

// Calls sweep_to(sweeper, last) for parts of columns, which end before the slab `last`. What
// make(column, first) returns, a unique pointer, begins with the slab `first`. It sweeps the parts
// of blocks that follow each other, as long as one thread has taken all of them.
template <class Sweeper, class Point, class Make, class Sweep_to>
void sweep_blocks(const Slabs<Point>& slabs, const Threads& threads, Stop_flag& stop,
                  const Make& make, const Sweep_to& sweep_to)
{
  struct Left
  {
    std::atomic<const void*> thread = nullptr; // the sweeper is for nobody else
    std::unique_ptr<Sweeper> sweeper;
  };
  const std::size_t blocks = threads.block_count();
  const std::size_t slab_count = slabs.slab_count();
  const bool are_left = slab_count >= blocks; // few slabs are not worth the memory
  const std::size_t count
    = are_left ? (std::min)(slab_blocks_per_block * blocks, 2 * slab_count) : blocks;
  const std::unique_ptr<Left[]> left(new Left[count + 1]); // before each block, and at the end
  const std::unique_ptr<Thread_pointers> pointers = threads.make_pointers();
  stop.run_each(threads, count, [&](std::size_t block, std::size_t end) {
    const void* const thread = pointers == nullptr ? nullptr : &pointers->own();
    std::unique_ptr<Sweeper> sweeper;
    if(left[block].thread.load(std::memory_order_relaxed) == thread)
      sweeper = std::move(left[block].sweeper);
    sweep_range(slabs, slabs.block(block, count).first, slabs.block(end - 1, count).second, sweeper,
                make, sweep_to);
    if(!are_left)
      return;
    left[end].sweeper = std::move(sweeper);
    left[end].thread.store(thread, std::memory_order_relaxed);
  });
  threads.run_blocks(are_left ? count + 1 : 0, [&](std::size_t i, std::size_t end) {
    for(; i != end; ++i)
      left[i].sweeper = nullptr; // takes long if one thread does it for many
  });
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_SLABS_SWEEP_BLOCKS_H
