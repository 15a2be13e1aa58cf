// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_STEP_BUDGET_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_STEP_BUDGET_H

// Bounds the steps that all tasks of a search take together, so that a search that gives up has
// taken linear time, with any number of threads.

#include <boost/config.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

class Step_budget
{
public:
  explicit Step_budget(std::size_t steps) : steps_(steps), left_(steps) {}

  // Whether a task needed steps.
  bool is_used() const { return left_.load(std::memory_order_relaxed) != steps_; }

  // Whether a task needed more steps than there were.
  bool is_exceeded() const { return is_exceeded_.load(std::memory_order_relaxed); }

  // Takes some steps for one task, and returns how many: none if there are none left.
  std::size_t take()
  {
    std::size_t left = left_.load(std::memory_order_relaxed);
    std::size_t taken;
    do
      taken = (std::min)(left, batch_size);
    while(!left_.compare_exchange_weak(left, left - taken, std::memory_order_relaxed));
    if(taken == 0)
      is_exceeded_.store(true, std::memory_order_relaxed);
    return taken;
  }

private:
  // So few that it matters little what the tasks of a search leave over.
  static constexpr std::size_t batch_size = 256;

  const std::size_t steps_;
  std::atomic<std::size_t> left_;
  std::atomic<bool> is_exceeded_ = false;
};

// Counts the steps of one task.
class Step_counter
{
public:
  explicit Step_counter(Step_budget& budget) : budget_(budget) {}

  // Takes some steps. Returns whether they were left.
  bool step(std::size_t count = 1)
  {
    if(left_ < count && !take(count))
      return false;
    left_ -= count;
    return true;
  }

private:
  // Not inline, so that loops that count steps stay short.
  BOOST_NOINLINE bool take(std::size_t count)
  {
    for(std::size_t taken = 1; left_ < count && taken != 0; left_ += taken)
      taken = budget_.take();
    return left_ >= count;
  }

  Step_budget& budget_;
  std::size_t left_ = 0; // of those taken from the budget
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_CLOSEST_PAIR_STEP_BUDGET_H
