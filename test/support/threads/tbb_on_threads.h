// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The part of oneTBB that the package and its tests use, on threads of the standard library.
// ThreadSanitizer sees how these threads wait for each other. It does not see this in the library
// oneTBB, unless that is compiled for it: then it takes each task for a race.
//
// A test that has the folder of this file on its include path, before that of oneTBB, includes the
// headers in tbb/ instead.

#ifndef THICK_INTERSECTION_TEST_SUPPORT_THREADS_TBB_ON_THREADS_H
#define THICK_INTERSECTION_TEST_SUPPORT_THREADS_TBB_ON_THREADS_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

namespace stand_in {

constexpr int max_threads = 4;

// More than threads.
inline std::size_t block_count() { return 16; }

inline std::atomic<int> idle_threads = max_threads - 1;
inline std::atomic<int> slot_count = max_threads; // of the arena that all are in

// A number for each thread. Identifiers of the standard library come back when a thread has ended.
inline std::atomic<std::size_t> thread_count = 0;
inline std::size_t thread_number()
{
  static thread_local const std::size_t number
    = thread_count.fetch_add(1, std::memory_order_relaxed);
  return number;
}

// Takes up to `wanted` idle threads. Relaxed: tasks are not ordered by this.
inline int take_threads(int wanted)
{
  int idle = idle_threads.load(std::memory_order_relaxed);
  while(!idle_threads.compare_exchange_weak(idle, idle - (std::min)(idle, wanted),
                                            std::memory_order_relaxed))
    ;
  return (std::min)(idle, wanted);
}

// Calls task(b) for the few numbers below `count`, by this thread and by idle ones. Throws what one
// of the tasks has thrown; tasks that have not begun by then are skipped.
inline void run(std::size_t count, const std::function<void(std::size_t)>& task)
{
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    try {
      for(std::size_t b; (b = next.fetch_add(1, std::memory_order_relaxed)) < count;)
        task(b);
    } catch(...) {
      const std::lock_guard<std::mutex> lock(mutex);
      error = std::current_exception();
      next.store(count, std::memory_order_relaxed);
    }
  };
  const int helper_count = count == 0 ? 0 : take_threads(static_cast<int>(count) - 1);
  std::vector<std::thread> helpers;
  for(int i = 0; i < helper_count; ++i)
    helpers.emplace_back(work);
  work();
  for(std::thread& helper : helpers)
    helper.join();
  idle_threads.fetch_add(helper_count, std::memory_order_relaxed);
  if(error)
    std::rethrow_exception(error);
}

} // namespace stand_in

} // namespace tbb

#include "support/tbb_by_blocks.h"

namespace tbb {

namespace this_task_arena {
inline int max_concurrency() { return stand_in::slot_count.load(std::memory_order_relaxed); }

// A thread that waits takes no other task here anyway.
template <class Function>
void isolate(const Function& function)
{
  function();
}
} // namespace this_task_arena

// Some slots are for threads that come from outside. Only for tests in which one thread does.
class task_arena
{
public:
  explicit task_arena(int slots, int slots_for_others = 1)
    : slots_(slots), helper_count_((std::min)(slots - slots_for_others, stand_in::max_threads - 1))
  {}

  template <class Function>
  void execute(const Function& function) const
  {
    const int slots = stand_in::slot_count.exchange(slots_);
    const int idle = stand_in::idle_threads.exchange(helper_count_);
    function();
    stand_in::idle_threads = idle;
    stand_in::slot_count = slots;
  }

private:
  const int slots_;
  const int helper_count_;
};

// Tests set the number of threads by this; here there are always as many.
struct global_control
{
  enum Parameter { max_allowed_parallelism };
  global_control(Parameter, std::size_t) {}
  ~global_control() {} // so that no compiler calls it unused
};

// The values are those of threads that have asked for one. A thread that ends leaves its value.
template <class T, class Allocator = std::allocator<T>, ets_key_usage_type = ets_no_key>
class enumerable_thread_specific
{
public:
  enumerable_thread_specific() : make_([] { return T(); }) {}
  explicit enumerable_thread_specific(const T& first) : make_([first] { return first; }) {}
  enumerable_thread_specific(const enumerable_thread_specific&) = delete;

  T& local()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    T*& value = of_threads_[stand_in::thread_number()];
    if(value == nullptr)
      value = &values_.emplace_back(make_());
    return *value;
  }

  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }

private:
  std::function<T()> make_;
  std::mutex mutex_;
  std::map<std::size_t, T*> of_threads_;
  std::deque<T> values_;
};

} // namespace tbb

#endif // THICK_INTERSECTION_TEST_SUPPORT_THREADS_TBB_ON_THREADS_H
