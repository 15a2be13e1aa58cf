// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The part of oneTBB that the package uses, with tasks that run in turn, and that are recorded as
// if many processors ran them (Task_record.h).
//
// A program that has the folder of this file on its include path, before that of oneTBB, includes
// the headers in tbb/ instead.

#ifndef THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_TBB_IN_TURN_H
#define THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_TBB_IN_TURN_H

#include "Task_record.h"

#include <cstddef>
#include <deque>
#include <map>

namespace tbb {
namespace stand_in {

// Four for each processor, which is what oneTBB begins with. It divides a block further when
// another thread is idle.
inline std::size_t block_count()
{
  return 4 * thick_benchmark::current_record()->processors();
}

template <class Task>
void run(std::size_t count, const Task& task)
{
  thick_benchmark::current_record()->run(count, task);
}

} // namespace stand_in
} // namespace tbb

#include "support/tbb_by_blocks.h"

namespace tbb {

namespace this_task_arena {
inline int max_concurrency()
{
  return static_cast<int>(thick_benchmark::current_record()->processors());
}

// A thread that waits takes no other task here anyway.
template <class Function>
void isolate(const Function& function)
{
  function();
}
} // namespace this_task_arena

// The values are those of processors whose tasks have asked for one.
template <class T, class Allocator = std::allocator<T>, ets_key_usage_type = ets_no_key>
class enumerable_thread_specific
{
public:
  explicit enumerable_thread_specific(const T& first = T()) : first_(first) {}
  enumerable_thread_specific(const enumerable_thread_specific&) = delete;

  T& local()
  {
    T*& value = of_processors_[thick_benchmark::current_record()->processor()];
    if(value == nullptr)
      value = &values_.emplace_back(first_);
    return *value;
  }

  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }

private:
  const T first_;
  std::map<std::size_t, T*> of_processors_;
  std::deque<T> values_;
};

} // namespace tbb

#endif // THICK_INTERSECTION_BENCHMARK_MANY_PROCESSORS_TBB_IN_TURN_H
