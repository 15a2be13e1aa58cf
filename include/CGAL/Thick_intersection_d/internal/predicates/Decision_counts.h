// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DECISION_COUNTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DECISION_COUNTS_H

// How many pairs each arithmetic has decided.
//
// Pairs of points that the first filter finds beyond the bound are not counted, because lanes pass
// over them without a count. Pairs of objects are counted one by one.

#include <CGAL/Arithmetic_tier.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

constexpr std::size_t arithmetic_tier_count
  = static_cast<std::size_t>(Arithmetic_tier::FILTERED_EXACT) + 1;

// The counts of one thread.
class Decision_counts
{
public:
  void add(Arithmetic_tier tier, std::uint64_t count = 1) { of(tier) += count; }

  void add(const Decision_counts& other)
  {
    for(std::size_t tier = 0; tier < counts_.size(); ++tier)
      counts_[tier] += other.counts_[tier];
  }

  std::uint64_t operator[](Arithmetic_tier tier) const
  {
    return counts_[static_cast<std::size_t>(tier)];
  }

private:
  std::uint64_t& of(Arithmetic_tier tier) { return counts_[static_cast<std::size_t>(tier)]; }

  std::array<std::uint64_t, arithmetic_tier_count> counts_ = {};
};

// The sum of the counts of all threads.
class Shared_decision_counts
{
public:
  void add(const Decision_counts& counts)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    counts_.add(counts);
  }

  // Call this when no thread adds counts any more.
  const Decision_counts& total() const { return counts_; }

private:
  std::mutex mutex_;
  Decision_counts counts_;
};

// Counts that all threads add to, one pair at a time.
class Atomic_decision_counts
{
public:
  void add(Arithmetic_tier tier)
  {
    counts_[static_cast<std::size_t>(tier)].fetch_add(1, std::memory_order_relaxed);
  }

  Decision_counts total() const
  {
    Decision_counts total;
    for(std::size_t tier = 0; tier < counts_.size(); ++tier)
      total.add(static_cast<Arithmetic_tier>(tier), counts_[tier]);
    return total;
  }

private:
  std::array<std::atomic<std::uint64_t>, arithmetic_tier_count> counts_ = {};
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DECISION_COUNTS_H
