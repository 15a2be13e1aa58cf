// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_THREADS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_THREADS_H

// Threads that share the blocks of a task, as data. What takes them at run time is the same code
// with oneTBB and without: only the program that makes them needs oneTBB. Only this file knows it.

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <type_traits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
inline constexpr bool has_tbb = true;
#else
inline constexpr bool has_tbb = false;
#endif

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

// A pointer for each thread that asks for its own. It is null at first.
class Thread_pointers
{
public:
  virtual ~Thread_pointers() = default;
  virtual void*& own() = 0;
};

// What Threads do.
struct Thread_functions
{
  bool are_many;
  std::size_t (*block_count)();
  void (*run)(std::size_t, const Block_task&);
  void (*run_each)(std::size_t, const Block_task&);
  void (*run_isolated)(const Block_task&);
  std::unique_ptr<Thread_pointers> (*make_pointers)();
};

// What Threads do if there is one thread.
struct One_thread
{
  static constexpr bool are_many = false;
  static std::size_t block_count() { return 1; }
  static void run(std::size_t count, const Block_task& task) { task(0, count); }
  static void run_each(std::size_t count, const Block_task& task) { task(0, count); }
  static void run_isolated(const Block_task& task) { task(0, 1); }
  static std::unique_ptr<Thread_pointers> make_pointers() { return nullptr; }
};

#ifdef CGAL_LINKED_WITH_TBB
// What Threads do if oneTBB has the threads.
struct Threads_of_tbb
{
  static constexpr bool are_many = true;

  static std::size_t block_count()
  {
    return 4 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  }

  static void run(std::size_t count, const Block_task& task)
  {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& block) {
      task(block.begin(), block.end());
    });
  }

  static void run_each(std::size_t count, const Block_task& task)
  {
    const auto run_block = [&](const auto& block) { task(block.begin(), block.end()); };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), run_block,
                      tbb::simple_partitioner());
  }

  static void run_isolated(const Block_task& task)
  {
    tbb::this_task_arena::isolate([&] { task(0, 1); });
  }

  static std::unique_ptr<Thread_pointers> make_pointers()
  {
    class Pointers : public Thread_pointers
    {
    public:
      void*& own() override { return pointers_.local(); }

    private:
      tbb::enumerable_thread_specific<void*, tbb::cache_aligned_allocator<void*>,
                                      tbb::ets_key_per_instance> pointers_{nullptr};
    };
    return std::make_unique<Pointers>();
  }
};
#else
struct Threads_of_tbb;
#endif

template <class Kind>
inline constexpr Thread_functions thread_functions
  = {Kind::are_many, Kind::block_count, Kind::run, Kind::run_each, Kind::run_isolated,
     Kind::make_pointers};

// Whether a tag asks for many threads. Explains to the compiler's user what is no tag.
template <class ConcurrencyTag>
constexpr bool is_parallel()
{
  constexpr bool are_many = std::is_convertible_v<ConcurrencyTag, Parallel_tag>;
  static_assert(are_many || std::is_convertible_v<ConcurrencyTag, Sequential_tag>,
                "The first template argument must be Sequential_tag or Parallel_tag.");
  static_assert(has_tbb || !are_many, "Parallel_tag is enabled but TBB is unavailable.");
  return has_tbb && are_many;
}

class Threads
{
public:
  // This thread alone.
  Threads() : Threads(Sequential_tag()) {}

  // Those of a tag. A copy is none, which Clang would ask about otherwise.
  template <class ConcurrencyTag,
            std::enable_if_t<!std::is_same_v<ConcurrencyTag, Threads>, int> = 0,
            class Kind
            = std::conditional_t<is_parallel<ConcurrencyTag>(), Threads_of_tbb, One_thread>>
  explicit Threads(ConcurrencyTag)
    : functions_(&thread_functions<Kind>)
  {}

  bool are_many() const { return functions_->are_many; }

  // Returns the number of blocks to divide elements into, when each block costs some work of its
  // own. So there are few blocks, but more than one per thread: then the threads finish at about
  // the same time.
  std::size_t block_count() const { return functions_->block_count(); }

  // Returns nothing if there is one thread.
  std::unique_ptr<Thread_pointers> make_pointers() const { return functions_->make_pointers(); }

  // Calls task(first, last) on blocks that cover the indices [0, count): one block in sequence,
  // several blocks at the same time in parallel.
  template <class Task>
  void run_blocks(std::size_t count, const Task& task) const
  {
    functions_->run(count, Block_task(task));
  }

  // As run_blocks(), but in parallel each index is a block. A thread takes one after another, and
  // when there is none left, the second half of those of another thread.
  template <class Task>
  void run_each(std::size_t count, const Task& task) const
  {
    functions_->run_each(count, Block_task(task));
  }

  // Calls task(), which may use oneTBB itself. While this thread waits for tasks of that, it takes
  // no other ones: these may want what the thread has locked.
  template <class Task>
  void run_isolated(const Task& task) const
  {
    functions_->run_isolated(Block_task([&](std::size_t, std::size_t) { task(); }));
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

  // Calls check(index) for each index in [0, count). If checks throw, what the check of the least
  // index throws passes through, in parallel as well.
  template <class Check>
  void check_each(std::size_t count, const Check& check) const
  {
    std::mutex mutex;
    std::size_t least = count; // of the indices whose check has thrown
    std::exception_ptr error;
    run_blocks(count, [&](std::size_t index, std::size_t last) {
      try {
        for(; index != last; ++index)
          check(index);
      }
      catch(...) {
        if(!are_many())
          throw;
        const std::lock_guard<std::mutex> lock(mutex);
        if(index < least) {
          least = index;
          error = std::current_exception();
        }
      }
    });
    if(error)
      std::rethrow_exception(error);
  }

private:
  const Thread_functions* functions_;
};

// Whether a search was stopped, as all of its threads see it.
class Stop_flag
{
public:
  void set() { is_set_.store(true, std::memory_order_relaxed); }
  bool is_set() const { return is_set_.load(std::memory_order_relaxed); }

  // Calls task(first, last) on blocks that cover the indices [0, count). What one of them throws
  // stops the others.
  template <class Task>
  void run_blocks(const Threads& threads, std::size_t count, const Task& task)
  {
    threads.run_blocks(count, stopping(task));
  }
  template <class Task>
  void run_each(const Threads& threads, std::size_t count, const Task& task)
  {
    threads.run_each(count, stopping(task));
  }

private:
  template <class Task>
  auto stopping(const Task& task)
  {
    return [this, &task](std::size_t first, std::size_t last) {
      try {
        task(first, last);
      }
      catch(...) {
        set();
        throw;
      }
    };
  }

  std::atomic<bool> is_set_ = false;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_THREADS_H
