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

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>

namespace tbb {

template <class T>
class blocked_range
{
public:
  blocked_range(T first, T last) : first_(first), last_(last) {}
  T begin() const { return first_; }
  T end() const { return last_; }

private:
  T first_, last_;
};

// In four blocks for each processor, which is what oneTBB begins with. It divides a block further
// when another thread is idle.
template <class T, class Body>
void parallel_for(const blocked_range<T>& range, const Body& body)
{
  thick_benchmark::Task_record& record = *thick_benchmark::current_record();
  const T size = range.end() - range.begin();
  const T blocks = (std::min)(size, static_cast<T>(4 * record.processors()));
  record.run(blocks, [&](std::size_t b) {
    body(blocked_range<T>(range.begin() + size * b / blocks,
                          range.begin() + size * (b + 1) / blocks));
  });
}

template <class... Task>
void parallel_invoke(const Task&... task)
{
  const std::function<void()> tasks[] = {task...};
  thick_benchmark::current_record()->run(sizeof...(Task), [&](std::size_t t) { tasks[t](); });
}

namespace this_task_arena {
inline int max_concurrency()
{
  return static_cast<int>(thick_benchmark::current_record()->processors());
}
} // namespace this_task_arena

template <class T>
using cache_aligned_allocator = std::allocator<T>;

enum ets_key_usage_type { ets_key_per_instance, ets_no_key };

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
