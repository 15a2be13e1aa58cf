// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_STOP_FLAG_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_STOP_FLAG_H

// Whether a search was stopped, as all of its threads see it.

#include <CGAL/Thick_intersection_d/internal/machine/Threads.h>

#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

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
    threads.run_blocks(count, [&](std::size_t first, std::size_t last) {
      try {
        task(first, last);
      }
      catch(...) {
        set();
        throw;
      }
    });
  }

private:
  std::atomic<bool> is_set_ = false;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_MACHINE_STOP_FLAG_H
