// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_SWEEP_ALLOWANCE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_SWEEP_ALLOWANCE_H

// How many candidates a sweep may still look at before it is given up, and what it has finished.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Each wanted pair allows some more candidates. So a sweep takes time for the first allowance, and
// O(1) time for each wanted pair. Threads share the allowance.
class Sweep_allowance
{
public:
  // As many as a sweep wants.
  Sweep_allowance() = default;

  Sweep_allowance(std::int64_t first, std::int64_t per_wanted_pair)
    : left_(first), per_wanted_pair_(per_wanted_pair)
  {}

  bool is_left() const { return left_.load(std::memory_order_relaxed) >= 0; }

  // After a part of the sweep: how many candidates there were, wanted pairs among them, and boxes
  // that are finished.
  void use(std::uint64_t candidates, std::uint64_t wanted_pairs, std::size_t finished)
  {
    finished_.fetch_add(finished, std::memory_order_relaxed);
    const std::int64_t earned = per_wanted_pair_ * static_cast<std::int64_t>(wanted_pairs);
    left_.fetch_add(earned - static_cast<std::int64_t>(candidates), std::memory_order_relaxed);
  }

  std::size_t finished() const { return finished_.load(std::memory_order_relaxed); }

private:
  std::atomic<std::int64_t> left_ = (std::numeric_limits<std::int64_t>::max)();
  std::atomic<std::size_t> finished_ = 0;
  std::int64_t per_wanted_pair_ = 0;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_BOXES_SWEEP_ALLOWANCE_H
