// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DECISION_COUNTS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DECISION_COUNTS_H

// How many pairs each arithmetic has decided, and a search that counts them.
//
// Pairs of points that the first filter finds beyond the bound are not counted, because lanes pass
// over them without a count. Pairs of objects are counted one by one.

#include <CGAL/Arithmetic_tier.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

constexpr std::size_t arithmetic_tier_count
  = static_cast<std::size_t>(Arithmetic_tier::FILTERED_EXACT) + 1;

// The counts of one thread.
class Decision_counts
{
public:
  void add(Arithmetic_tier tier, std::uint64_t count = 1)
  {
    counts_[static_cast<std::size_t>(tier)] += count;
  }

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
  std::array<std::uint64_t, arithmetic_tier_count> counts_ = {};
};

// Counts that all threads add to.
class Shared_decision_counts
{
public:
  void add(Arithmetic_tier tier, std::uint64_t count = 1)
  {
    counts_[static_cast<std::size_t>(tier)].fetch_add(count, std::memory_order_relaxed);
  }

  void add(const Decision_counts& other)
  {
    for(std::size_t tier = 0; tier < counts_.size(); ++tier)
      add(static_cast<Arithmetic_tier>(tier), other[static_cast<Arithmetic_tier>(tier)]);
  }

  // Call this when no thread adds counts any more.
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

// Returns search(least_tier, &counts), and sets `profile` to `found`, the profile of the scene,
// with the tier that is forced in `profile`, and the counts. `Profile` is Scene_profile, which
// holds counts itself.
//
// The least tier is the first arithmetic after the filter. What the whole scene needs is more than
// most of its pairs do, so wider integers and exact numbers wait for these.
template <class Profile, class Search>
bool search_profiled(Profile& profile, Profile found, const Search& search)
{
  if(const std::optional<Arithmetic_tier> forced = profile.forced_tier())
    found.force_tier(*forced);
  Shared_decision_counts counts;
  const bool is_complete
    = search(found.forced_tier() ? found.tier()
                                 : (std::min)(found.tier(), Arithmetic_tier::INT64), &counts);
  found.set_counts(counts.total());
  profile = found;
  return is_complete;
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_DECISION_COUNTS_H
