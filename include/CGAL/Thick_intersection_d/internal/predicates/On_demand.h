// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ON_DEMAND_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ON_DEMAND_H

// A value that is made when the first thread asks for it, because most searches never do.

#include <atomic>
#include <mutex>
#include <optional>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Several threads may ask at once; all but one of them wait.
template <class Value>
class On_demand
{
public:
  On_demand() = default;

  // A copy makes a value of its own.
  On_demand(const On_demand&) {}
  On_demand& operator=(const On_demand&)
  {
    is_made_ = false;
    value_.reset();
    return *this;
  }

  // Returns the value, which is what the first call of `make` that did not throw returned.
  template <class Make>
  const Value& get(const Make& make)
  {
    if(!is_made_.load(std::memory_order_acquire)) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if(!value_) {
        value_.emplace(make());
        is_made_.store(true, std::memory_order_release);
      }
    }
    return *value_;
  }

private:
  std::mutex mutex_;
  std::atomic<bool> is_made_ = false;
  std::optional<Value> value_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_PREDICATES_ON_DEMAND_H
