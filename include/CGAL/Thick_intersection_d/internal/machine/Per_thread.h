// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PER_THREAD_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PER_THREAD_H

// A value for each thread that asks for it.

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// In sequence there is one value, and in parallel one for each thread that asks. All are copies of
// the first value. The layout is the same with oneTBB and without.
template <class T>
class Per_thread
{
public:
  Per_thread(const T& first, const Threads& threads)
    : first_(first), pointers_(threads.make_pointers())
  {}

  T& local()
  {
    if(pointers_ == nullptr)
      return first_;
    void*& own = pointers_->own();
    if(own == nullptr)
      own = make_value();
    return *static_cast<T*>(own);
  }

  template <class Task>
  void for_each(const Task& task)
  {
    if(pointers_ == nullptr)
      task(first_);
    for(Value* v = values_.get(); v != nullptr; v = v->next.get())
      task(v->value);
  }

  // Calls task(value) for all values, by the threads in parallel.
  template <class Task>
  void for_each_at_once(const Threads& threads, const Task& task)
  {
    std::vector<T*> values;
    for_each([&](T& value) { values.push_back(&value); });
    threads.run_blocks(values.size(), [&](std::size_t i, std::size_t last) {
      for(; i != last; ++i)
        task(*values[i]);
    });
  }

private:
  // Threads write to their values at once, so no two of these share a line of a cache.
  struct Value
  {
    explicit Value(const T& first) : value(first) {}
    CGAL_THICK_INTERSECTION_D_RARELY_CALLED ~Value() = default;
    alignas(64) T value;
    std::unique_ptr<Value> next;
  };

  CGAL_THICK_INTERSECTION_D_RARELY_CALLED T* make_value()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto value = std::make_unique<Value>(first_);
    value->next = std::move(values_);
    values_ = std::move(value);
    return &values_->value;
  }

  T first_;
  const std::unique_ptr<Thread_pointers> pointers_; // none in sequence
  std::mutex mutex_;
  std::unique_ptr<Value> values_; // in a chain
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_PER_THREAD_H
