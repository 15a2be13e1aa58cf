// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_THREADS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_THREADS_H

// Threads that share the blocks of a task, as data. What takes them at run time is the same code
// with oneTBB and without: only the program that makes them needs oneTBB.

#include <CGAL/Thick_intersection_d/internal/machine/parallel.h>

#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A function of a block of indices. Does not own the function.
class Block_task
{
public:
  template <class Function>
  explicit Block_task(const Function& function)
    : function_(&function),
      call_([](const void* f, std::size_t first, std::size_t last) {
        (*static_cast<const Function*>(f))(first, last);
      })
  {}

  void operator()(std::size_t first, std::size_t last) const { call_(function_, first, last); }

private:
  const void* function_;
  void (*call_)(const void*, std::size_t, std::size_t);
};

class Threads
{
public:
  // This thread alone.
  Threads() : Threads(Sequential_tag()) {}

  // Those of a tag.
  template <class ConcurrencyTag>
  explicit Threads(ConcurrencyTag)
    : block_count_(&internal::block_count<ConcurrencyTag>), run_(&run<ConcurrencyTag>),
      are_many_(is_parallel_v<ConcurrencyTag>)
  {}

  bool are_many() const { return are_many_; }

  // As block_count() of parallel.h.
  std::size_t block_count() const { return block_count_(); }

  // Calls task(first, last) on blocks that cover the indices [0, count).
  template <class Task>
  void run_blocks(std::size_t count, const Task& task) const
  {
    run_(count, Block_task(task));
  }

  // Calls task(block, first, last) for `blocks` blocks that cover the indices [0, count).
  template <class Task>
  void run_numbered_blocks(std::size_t blocks, std::size_t count, const Task& task) const
  {
    run_blocks(blocks, [&](std::size_t block, std::size_t end) {
      for(; block != end; ++block)
        task(block, block * count / blocks, (block + 1) * count / blocks);
    });
  }

  // Runs the tasks, perhaps at the same time. Each task returns whether to go on. Returns whether
  // all tasks returned true. In sequence, no task runs after a task that returned false.
  template <class Task1, class Task2, class Task3>
  bool run_all(const Task1& task1, const Task2& task2, const Task3& task3) const
  {
    bool go_on[] = {false, false, false}; // also if a task is skipped, because another one throws
    run_blocks(3, [&](std::size_t i, std::size_t end) {
      for(bool goes_on = true; goes_on && i != end; ++i)
        goes_on = go_on[i] = i == 0 ? task1() : i == 1 ? task2() : task3();
    });
    return go_on[0] && go_on[1] && go_on[2];
  }

private:
  template <class ConcurrencyTag>
  static void run(std::size_t count, const Block_task& task)
  {
    internal::for_each_block<ConcurrencyTag>(count, task);
  }

  std::size_t (*block_count_)();
  void (*run_)(std::size_t, const Block_task&);
  bool are_many_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_THREADS_H
