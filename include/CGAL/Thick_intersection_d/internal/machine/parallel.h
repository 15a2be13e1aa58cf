// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PARALLEL_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PARALLEL_H

// Runs independent tasks in turn or at the same time. Only this file knows oneTBB.

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <exception>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

template <class ConcurrencyTag>
inline constexpr bool is_parallel_v = std::is_convertible_v<ConcurrencyTag, Parallel_tag>;

#ifdef CGAL_LINKED_WITH_TBB
inline constexpr bool has_tbb = true;
#else
inline constexpr bool has_tbb = false;
#endif

// Runs the tasks. Each task returns whether to go on. Returns whether all tasks returned true. In
// sequence, no task runs after a task that returned false.
template <class ConcurrencyTag, class Task1, class Task2, class Task3>
bool invoke_all(const Task1& task1, const Task2& task2, const Task3& task3)
{
  static_assert(has_tbb || !is_parallel_v<ConcurrencyTag>,
                "Parallel_tag is enabled but TBB is unavailable.");
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel_v<ConcurrencyTag>) {
    // A task that oneTBB skips, because another task throws, leaves false.
    bool go_on[3] = {false, false, false};
    tbb::parallel_invoke([&] { go_on[0] = task1(); },
                         [&] { go_on[1] = task2(); },
                         [&] { go_on[2] = task3(); });
    return go_on[0] && go_on[1] && go_on[2];
  }
  else
#endif
    return task1() && task2() && task3();
}

// Calls task(first, last) on blocks that cover the indices [0, count): one block in sequence,
// several blocks at the same time in parallel.
template <class ConcurrencyTag, class Task>
void for_each_block(std::size_t count, const Task& task)
{
  static_assert(has_tbb || !is_parallel_v<ConcurrencyTag>,
                "Parallel_tag is enabled but TBB is unavailable.");
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel_v<ConcurrencyTag>)
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& block) {
      task(block.begin(), block.end());
    });
  else
#endif
    task(std::size_t(0), count);
}

// Returns the number of blocks to divide elements into, when each block costs some work of its own.
// So there are few blocks, but more than one per thread: then the threads finish at about the same
// time.
template <class ConcurrencyTag>
std::size_t block_count()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel_v<ConcurrencyTag>)
    return 4 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  else
#endif
    return 1;
}

// Calls task(block, first, last) for `blocks` blocks that cover the indices [0, count).
template <class ConcurrencyTag, class Task>
void for_each_numbered_block(std::size_t blocks, std::size_t count, const Task& task)
{
  for_each_block<ConcurrencyTag>(blocks, [&](std::size_t block, std::size_t end) {
    for(; block != end; ++block)
      task(block, block * count / blocks, (block + 1) * count / blocks);
  });
}

// Calls check(index) for each index in [0, count). If checks throw, what the check of the least
// index throws passes through, in parallel as well.
template <class ConcurrencyTag, class Check>
void check_each(std::size_t count, const Check& check)
{
  if constexpr(is_parallel_v<ConcurrencyTag>) {
    std::vector<std::exception_ptr> errors(block_count<ConcurrencyTag>());
    const auto check_block = [&](std::size_t block, std::size_t first, std::size_t last) {
      try {
        for(; first != last; ++first)
          check(first);
      }
      catch(...) {
        errors[block] = std::current_exception();
      }
    };
    for_each_numbered_block<ConcurrencyTag>(errors.size(), count, check_block);
    for(const std::exception_ptr& error : errors)
      if(error)
        std::rethrow_exception(error);
  }
  else
    for(std::size_t index = 0; index < count; ++index)
      check(index);
}

// A value for each thread that asks for it: a copy of `first`.
template <class ConcurrencyTag, class T>
class Per_thread
{
public:
  explicit Per_thread(const T& first) : values_(first) {}

  T& local()
  {
    if constexpr(is_parallel_v<ConcurrencyTag>)
      return values_.local();
    else
      return values_;
  }

  template <class Task>
  void for_each(const Task& task)
  {
    if constexpr(is_parallel_v<ConcurrencyTag>)
      std::for_each(values_.begin(), values_.end(), task);
    else
      task(values_);
  }

  // Calls task(value) for the values of all threads, by all threads in parallel.
  template <class Task>
  void for_each_at_once(const Task& task)
  {
    std::vector<T*> values;
    for_each([&](T& value) { values.push_back(&value); });
    for_each_block<ConcurrencyTag>(values.size(), [&](std::size_t i, std::size_t last) {
      for(; i != last; ++i)
        task(*values[i]);
    });
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  using Values = tbb::enumerable_thread_specific<T, tbb::cache_aligned_allocator<T>,
                                                 tbb::ets_key_per_instance>;
  std::conditional_t<is_parallel_v<ConcurrencyTag>, Values, T> values_;
#else
  T values_;
#endif
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PARALLEL_H
