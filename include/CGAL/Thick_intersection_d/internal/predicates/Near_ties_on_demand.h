// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIES_ON_DEMAND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIES_ON_DEMAND_H

// The predicate for near ties of a scene, made when the first near tie needs it: it reads the grid
// of all points, and most scenes have no near ties.

#include <CGAL/Thick_intersection_d/internal/predicates/Near_tie_predicate.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Several threads may ask at once; all but one of them wait.
class Near_ties_on_demand
{
public:
  explicit Near_ties_on_demand(std::function<Near_tie_predicate()> make) : make_(std::move(make)) {}

  const Near_tie_predicate& get() const
  {
    if(!is_made_.load(std::memory_order_acquire)) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if(!is_made_.load(std::memory_order_relaxed)) {
        predicate_ = make_();
        is_made_.store(true, std::memory_order_release);
      }
    }
    return predicate_;
  }

private:
  const std::function<Near_tie_predicate()> make_;
  mutable std::mutex mutex_;
  mutable std::atomic<bool> is_made_ = false;
  mutable Near_tie_predicate predicate_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_NEAR_TIES_ON_DEMAND_H
